// SPDX-License-Identifier: BSD-3-Clause
#include "Preferences.h"

#include "../support/TemporaryFolder.h"
#include "WxText.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <wx/fileconf.h>
#include <wx/init.h>
#include <wx/log.h>

namespace offmap::window {

namespace {

const std::array<wxRect, 1> screens{wxRect(0, 0, 1920, 1080)};

class PreferencesTest : public testing::Test {
 protected:
    static void SetUpTestSuite() { toolkit_ = std::make_unique<wxInitializer>(); }
    static void TearDownTestSuite() { toolkit_.reset(); }

    /// As the next start of the program finds it.
    std::unique_ptr<wxFileConfig> open() const {
        return std::make_unique<wxFileConfig>("", "", toWx((folder / "offmap-view").string()), "",
                                              wxCONFIG_USE_LOCAL_FILE);
    }
    void save(const ViewState& state) const {
        const auto file = open();
        Preferences(*file).save(state);
    }
    ViewState load() const {
        const auto file = open();
        return Preferences(*file).load(screens);
    }
    void write(const char* key, const wxString& value) const { open()->Write(key, value); }

    test::TemporaryFolder folder;

 private:
    static inline std::unique_ptr<wxInitializer> toolkit_;  // without a screen
};

}  // namespace

TEST_F(PreferencesTest, firstStartHasDefaults) {
    const ViewState state = load();
    EXPECT_FALSE(state.window || state.camera || state.maximised);
    EXPECT_TRUE(state.dark && state.shown.mapped && state.sashes.empty() && state.folder.empty());
    EXPECT_EQ(state.speed, 1);
}

TEST_F(PreferencesTest, everythingIsThereAgain) {
    ViewState state;
    state.window = wxRect(-20, 30, 1200, 800);
    state.maximised = true;
    state.sashes = {{"right", 380}, {"bottom", 620}};
    state.cameraMode = CameraMode::Follow;
    state.camera = view::Camera{{1.25, -5412345.678, 3}, 0.5, 1.25, 40, 0};
    state.dark = false;
    state.pointSize = 4.5;
    state.colourBy = view::ColourBy::Residual;
    state.shown = {false, false, false, false};
    state.speed = std::numeric_limits<double>::infinity();
    state.folder = "/logs/$HOME/Käfer";
    save(state);

    const ViewState again = load();
    EXPECT_EQ(again.window, state.window);
    EXPECT_TRUE(again.maximised);
    EXPECT_EQ(again.sashes, state.sashes);
    EXPECT_EQ(again.cameraMode, CameraMode::Follow);
    ASSERT_TRUE(again.camera);
    EXPECT_EQ(again.camera->target.x, 1.25);
    EXPECT_EQ(again.camera->target.y, -5412345.678);
    EXPECT_EQ(again.camera->elevation, 1.25);
    EXPECT_EQ(again.camera->distance, 40);
    EXPECT_FALSE(again.dark);
    EXPECT_EQ(again.pointSize, 4.5);
    EXPECT_EQ(again.colourBy, view::ColourBy::Residual);
    EXPECT_FALSE(again.shown.mapped || again.shown.walls || again.shown.ellipse ||
                 again.shown.rest);
    EXPECT_TRUE(std::isinf(again.speed));
    EXPECT_EQ(again.folder, state.folder);
}

TEST_F(PreferencesTest, aCameraThatIsGoneIsNotKept) {
    ViewState state;
    state.camera = view::Camera{};
    save(state);
    state.camera.reset();
    save(state);
    EXPECT_FALSE(load().camera);
}

TEST_F(PreferencesTest, aWindowOutsideOfEveryScreenIsForgotten) {
    ViewState state;
    for (const wxRect& window : {wxRect(1919, 0, 800, 600), wxRect(100, 1080, 800, 600),
                                 wxRect(100, -300, 800, 600), wxRect(-790, 10, 800, 600)}) {
        state.window = window;
        save(state);
        EXPECT_FALSE(load().window) << window.x << ", " << window.y;
    }
}

TEST_F(PreferencesTest, aDamagedValueReadsAsItsDefault) {
    ViewState state;
    state.window = wxRect(10, 20, 800, 600);
    state.camera = view::Camera{};
    state.sashes = {{"right", 300}, {"bottom", 400}};
    save(state);
    write("/window/width", "wide");
    write("/camera/distance_m", "nan");
    write("/camera/mode", "7");
    write("/view/point_size_px", "1e300");
    write("/view/dark", "maybe");
    write("/view/colour_by", "-1");
    write("/play/speed", "-3");
    write("/sashes/right", "-99999999999999999999");

    const ViewState again = load();
    EXPECT_FALSE(again.window || again.camera);
    EXPECT_EQ(again.cameraMode, ViewState{}.cameraMode);
    EXPECT_EQ(again.pointSize, ViewState{}.pointSize);
    EXPECT_TRUE(again.dark);
    EXPECT_EQ(again.colourBy, view::ColourBy::Label);
    EXPECT_EQ(again.speed, 1);
    EXPECT_EQ(again.sashes, (std::map<std::string, int>{{"bottom", 400}}));
}

TEST_F(PreferencesTest, aFileOfOtherBytesReadsAsNone) {
    std::string bytes;
    for (int i = 0; i < 4096; ++i) bytes.push_back(static_cast<char>((i * 197) % 251));
    test::writeFile(folder / "offmap-view", bytes);
    const wxLogNull silent;
    EXPECT_FALSE(load().window);
    const auto file = open();
    EXPECT_TRUE(Preferences(*file).recentLogs().empty());
}

TEST_F(PreferencesTest, recentLogsAreTheNewestTenWithoutDoubles) {
    const auto file = open();
    Preferences preferences(*file);
    for (int i = 0; i < 12; ++i) preferences.addRecentLog("/logs/" + std::to_string(i));
    preferences.addRecentLog("/logs/x/../5");
    preferences.addRecentMap("/maps/a");
    preferences.addRecentLog("");

    const auto logs = Preferences(*open()).recentLogs();
    ASSERT_EQ(logs.size(), 10);
    EXPECT_EQ(logs[0], "/logs/5");
    EXPECT_EQ(logs[1], "/logs/11");
    EXPECT_EQ(logs[9], "/logs/2");
    EXPECT_EQ(preferences.recentMaps(), std::vector<std::string>{"/maps/a"});
    preferences.forgetRecentLog("/logs/11");
    EXPECT_EQ(preferences.recentLogs().size(), 9);
}

TEST_F(PreferencesTest, aRelativePathIsRememberedFromTheRoot) {
    const auto file = open();
    Preferences preferences(*file);
    preferences.addRecentLog("run.rawlog");
    EXPECT_EQ(preferences.recentLogs().at(0),
              (std::filesystem::current_path() / "run.rawlog").string());
}

}  // namespace offmap::window
