// SPDX-License-Identifier: BSD-3-Clause
// How quickly the window paints and answers while it plays a simulated log as fast as it can. Needs
// a screen; `./dev bench window` gives it one that nobody sees.
#include "../../support/RunProgram.h"
#include "../../support/TemporaryFolder.h"
#include "FileReader.h"
#include "Script.h"
#include "ViewOptions.h"

#include <offmap/rawlog/RegisterClasses.h>

#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <memory>
#include <thread>
#include <wx/app.h>
#include <wx/fileconf.h>
#include <wx/init.h>

namespace {

using namespace offmap;

struct Options {
    std::string world = "corridor", scanner = "paper";
    size_t turns = 100;
    std::filesystem::path folder;  ///< of the log; empty: one that is removed afterwards
    test::ScriptOptions script;

    void addTo(CLI::App& app) {
        app.add_option("--world", world, "As of offmap simulate")->capture_default_str();
        app.add_option("--scanner", scanner, "As of offmap simulate")->capture_default_str();
        app.add_option("--turns", turns, "Of the log, which is played again and again")
            ->capture_default_str();
        app.add_option("--folder", folder, "Keep the log there; one that is there is played");
        app.add_option("--seconds", script.seconds, "For each rate")->capture_default_str();
        app.add_option("--moves", script.moves, "Of the pointer, 20 a second")
            ->capture_default_str();
        app.add_option("--soak", script.soak, "Seconds to play on and tell the memory")
            ->capture_default_str();
    }
};

void simulate(const Options& options, const std::filesystem::path& folder) {
    if (std::filesystem::exists(folder / "scans.rawlog")) return;
    const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    const auto run = test::runProgram({here / "offmap", "simulate", options.world, "--scanner",
                                       options.scanner, "--scans", std::to_string(options.turns),
                                       "--quiet", "--out", folder.string()});
    if (run.exitCode != 0) throw std::runtime_error(run.err);
}

class Measured : public wxApp {
 public:
    Measured(const Options& options, std::filesystem::path folder)
        : options_(options), folder_(std::move(folder)) {}

    bool OnInit() override {
        const std::vector<std::string> arguments{(folder_ / "scans.rawlog").string(),
                                                 "--map",
                                                 (folder_ / "map.lines").string(),
                                                 "--play",
                                                 "--speed",
                                                 "max"};
        CLI::App commandLine;
        window::ViewOptions view;
        view.addTo(commandLine);
        commandLine.parse(
            std::vector(arguments.rbegin(), arguments.rend()));  // CLI11 takes them from the back
        window::SessionRequest request;
        request.live = view.request();
        request.config = view.shared.readConfig();
        request.play = true;
        settings_ = std::make_unique<wxFileConfig>("", "", (folder_ / "settings").string());
        auto* frame = new window::MainFrame(window::FileReader(arguments), request, *settings_);
        frame->Show();
        frame->Bind(wxEVT_CLOSE_WINDOW, [this](wxCloseEvent& event) {
            script_ = {};  // it ends before the window does
            event.Skip();
        });
        meter_ = std::make_unique<test::PaintMeter>(*frame);
        // The canvas has its size once the window has been laid out.
        frame->CallAfter([this, frame] { start(*frame); });
        return true;
    }

    int OnRun() override {
        const int code = wxApp::OnRun();
        return failed_ ? 2 : code;
    }

 private:
    void start(window::MainFrame& frame) {
        script_ = std::jthread([this, &frame](const std::stop_token& stop) {
            try {
                std::this_thread::sleep_for(std::chrono::seconds(2));
                test::Script(frame, *meter_, options_.script).run(stop);
            } catch (const std::exception& error) {
                fmt::print(stderr, "{}\n", error.what());
                failed_ = true;
            }
            if (!stop.stop_requested()) frame.CallAfter([&frame] { frame.Close(true); });
        });
    }

    const Options options_;
    const std::filesystem::path folder_;
    std::unique_ptr<wxConfigBase> settings_;
    std::unique_ptr<test::PaintMeter> meter_;
    std::atomic_bool failed_ = false;
    std::jthread script_;
};

int run(const Options& options, char** argv) {
    const test::TemporaryFolder own;
    const auto folder = options.folder.empty() ? own.path() / "log" : options.folder;
    simulate(options, folder);
    rawlog::registerMrptClasses();
    wxApp::SetInstance(new Measured(options, folder));
    int argc = 1;
    return wxEntry(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
    if (window::FileReader::isWanted(argc, argv)) return window::FileReader::run(argc, argv);
    CLI::App app("Measures how quickly the window paints and answers.");
    Options options;
    options.addTo(app);
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
