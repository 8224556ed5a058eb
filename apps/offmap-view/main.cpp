// SPDX-License-Identifier: BSD-3-Clause
#include "FileReader.h"
#include "Screen.h"
#include "ViewApp.h"
#include "ViewOptions.h"
#include "input/Console.h"
#include "input/Guarded.h"
#include "input/UsageError.h"

#include <offmap/rawlog/RegisterClasses.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>
#include <vector>
#include <wx/init.h>

namespace {

using namespace offmap::window;

int show(const ViewOptions& options, const std::vector<std::string>& arguments, char** argv) {
    SessionRequest request;
    request.live = options.request();
    request.config = options.shared.readConfig();
    request.play = options.play;
    offmap::rawlog::registerMrptClasses();
    requireScreen();
    wxApp::SetInstance(new ViewApp(FileReader(arguments), std::move(request)));
    int argc = 1;  // the toolkit has no options of its own
    return wxEntry(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace offmap::app;
    prepareStandardStreams();
    if (FileReader::isWanted(argc, argv)) return FileReader::run(argc, argv);
    CLI::App app("Watch what offmap takes out of 3D scans: live, or along a log.", "offmap-view");
    app.set_version_flag("--version", "offmap-view " OFFMAP_VERSION);
    app.failure_message([](const CLI::App*, const CLI::Error& error) {
        return fmt::format("offmap-view: {}; offmap-view --help tells what it takes\n",
                           error.what());
    });
    ViewOptions options;
    options.addTo(app);
    return reportingErrors([&] {
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return static_cast<int>(app.exit(error) == 0 ? exitDone : exitUsage);
        }
        return show(options, {argv + 1, argv + argc}, argv);
    });
}
