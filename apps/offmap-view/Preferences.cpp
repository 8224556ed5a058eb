// SPDX-License-Identifier: BSD-3-Clause
#include "Preferences.h"

#include "WxText.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <wx/confbase.h>

namespace offmap::window {

namespace {

constexpr long largestLength = 32767;  // [px] of an X11 window
constexpr double largestPlace = 1e9;   // [m] beyond any map, even one in UTM coordinates
constexpr size_t mostRecent = 10;

/// Only what is within these limits.
std::optional<double> numberAt(const wxConfigBase& file, const wxString& key, double min,
                               double max) {
    double value = 0;
    const bool good = file.HasEntry(key) && file.Read(key, &value) && std::isfinite(value);
    return good && value >= min && value <= max ? std::optional(value) : std::nullopt;
}

void readNumber(const wxConfigBase& file, const wxString& key, double min, double max,
                double& value) {
    value = numberAt(file, key, min, max).value_or(value);
}

std::optional<int> lengthAt(const wxConfigBase& file, const wxString& key, long min) {
    long value = 0;
    const bool good = file.HasEntry(key) && file.Read(key, &value);
    if (!good || value < min || value > largestLength) return std::nullopt;
    return static_cast<int>(value);
}

void readSwitch(const wxConfigBase& file, const wxString& key, bool& value) {
    long number = 0;
    if (file.HasEntry(key) && file.Read(key, &number) && (number == 0 || number == 1)) {
        value = number == 1;
    }
}

template <typename Choice>
void readChoice(const wxConfigBase& file, const wxString& key, Choice last, Choice& value) {
    const auto number = lengthAt(file, key, 0);
    if (number && *number <= static_cast<int>(last)) value = static_cast<Choice>(*number);
}

/// Enough of the title bar is on a screen to take hold of it.
bool canBeSeen(const wxRect& window, std::span<const wxRect> screens) {
    constexpr int grip = 64;  // [px]
    const wxRect titleBar(window.x, window.y, window.width, grip / 2);
    return std::ranges::any_of(screens, [&](const wxRect& screen) {
        const wxRect seen = titleBar.Intersect(screen);
        return seen.width >= grip && seen.height >= titleBar.height / 2;
    });
}

std::optional<wxRect> readWindow(const wxConfigBase& file, std::span<const wxRect> screens) {
    constexpr long smallest = 200;  // [px]
    const auto x = lengthAt(file, "/window/x", -largestLength);
    const auto y = lengthAt(file, "/window/y", -largestLength);
    const auto width = lengthAt(file, "/window/width", smallest);
    const auto height = lengthAt(file, "/window/height", smallest);
    if (!x || !y || !width || !height) return std::nullopt;
    const wxRect window(*x, *y, *width, *height);
    return canBeSeen(window, screens) ? std::optional(window) : std::nullopt;
}

std::map<std::string, int> readSashes(wxConfigBase& file) {
    std::map<std::string, int> sashes;
    const wxConfigPathChanger inGroup(&file, "/sashes/");
    wxString name;
    long at = 0;
    for (bool more = file.GetFirstEntry(name, at); more; more = file.GetNextEntry(name, at)) {
        if (const auto position = lengthAt(file, name, 1)) sashes[fromWx(name)] = *position;
    }
    return sashes;
}

std::optional<view::Camera> readCamera(const wxConfigBase& file) {
    const auto x = numberAt(file, "/camera/x_m", -largestPlace, largestPlace);
    const auto y = numberAt(file, "/camera/y_m", -largestPlace, largestPlace);
    const auto z = numberAt(file, "/camera/z_m", -largestPlace, largestPlace);
    const auto azimuth = numberAt(file, "/camera/azimuth_rad", -10, 10);
    const auto elevation = numberAt(file, "/camera/elevation_rad", -M_PI_2, M_PI_2);
    const auto distance = numberAt(file, "/camera/distance_m", 1e-3, largestPlace);
    const auto side = numberAt(file, "/camera/shorter_side_m", 0, largestPlace);
    if (!x || !y || !z || !azimuth || !elevation || !distance || !side) return std::nullopt;
    return view::Camera{{*x, *y, *z}, *azimuth, *elevation, *distance, *side};
}

/// All digits: wxConfig by itself writes six.
void writeNumber(wxConfigBase& file, const wxString& key, double value) {
    file.Write(key, toWx(fmt::format("{}", value)));
}

void writeWindow(wxConfigBase& file, const wxRect& window) {
    file.Write("/window/x", window.x);
    file.Write("/window/y", window.y);
    file.Write("/window/width", window.width);
    file.Write("/window/height", window.height);
}

void writeCamera(wxConfigBase& file, const view::Camera& camera) {
    writeNumber(file, "/camera/x_m", camera.target.x);
    writeNumber(file, "/camera/y_m", camera.target.y);
    writeNumber(file, "/camera/z_m", camera.target.z);
    writeNumber(file, "/camera/azimuth_rad", camera.azimuth);
    writeNumber(file, "/camera/elevation_rad", camera.elevation);
    writeNumber(file, "/camera/distance_m", camera.distance);
    writeNumber(file, "/camera/shorter_side_m", camera.shorterSide);
}

// An infinite speed is written as 0: not every locale's reader takes "inf".
constexpr double slowest = 0.01, fastest = 1000;

void readSpeed(const wxConfigBase& file, double& speed) {
    readNumber(file, "/play/speed", 0, fastest, speed);
    if (speed < slowest) speed = speed == 0 ? std::numeric_limits<double>::infinity() : 1;
}

}  // namespace

Preferences::Preferences(wxConfigBase& file) : file_(file) {
    file_.SetExpandEnvVars(false);  // a path may hold a $
}

ViewState Preferences::load(std::span<const wxRect> screens) const {
    ViewState state;
    state.window = readWindow(file_, screens);
    readSwitch(file_, "/window/maximised", state.maximised);
    state.sashes = readSashes(file_);
    readChoice(file_, "/camera/mode", CameraMode::Perspective, state.cameraMode);
    state.camera = readCamera(file_);
    readSwitch(file_, "/view/dark", state.dark);
    readNumber(file_, "/view/point_size_px", ViewState::minPointSize, ViewState::maxPointSize,
               state.pointSize);
    readChoice(file_, "/view/colour_by", view::ColourBy::Reason, state.colourBy);
    readSwitch(file_, "/view/mapped", state.shown.mapped);
    readSwitch(file_, "/view/walls", state.shown.walls);
    readSwitch(file_, "/view/ellipse", state.shown.ellipse);
    readSwitch(file_, "/view/rest", state.shown.rest);
    readSpeed(file_, state.speed);
    state.folder = fromWx(file_.Read("/folder", wxString()));
    return state;
}

void Preferences::save(const ViewState& state) {
    if (state.window) writeWindow(file_, *state.window);
    file_.Write("/window/maximised", static_cast<long>(state.maximised));
    for (const auto& [name, position] : state.sashes) {
        file_.Write(toWx("/sashes/" + name), position);
    }
    file_.DeleteGroup("/camera");
    file_.Write("/camera/mode", static_cast<long>(state.cameraMode));
    if (state.camera) writeCamera(file_, *state.camera);
    file_.Write("/view/dark", static_cast<long>(state.dark));
    writeNumber(file_, "/view/point_size_px", state.pointSize);
    file_.Write("/view/colour_by", static_cast<long>(state.colourBy));
    file_.Write("/view/mapped", static_cast<long>(state.shown.mapped));
    file_.Write("/view/walls", static_cast<long>(state.shown.walls));
    file_.Write("/view/ellipse", static_cast<long>(state.shown.ellipse));
    file_.Write("/view/rest", static_cast<long>(state.shown.rest));
    writeNumber(file_, "/play/speed", std::isinf(state.speed) ? 0.0 : state.speed);
    file_.Write("/folder", toWx(state.folder));
    file_.Flush();
}

std::vector<std::string> Preferences::recent(const char* list) const {
    std::vector<std::string> paths;
    for (size_t place = 1; place <= mostRecent; ++place) {
        std::string path = fromWx(file_.Read(wxString::Format("%s/%zu", list, place), wxString()));
        const bool known = std::ranges::find(paths, path) != paths.end();
        if (!path.empty() && !known) paths.push_back(std::move(path));
    }
    return paths;
}

void Preferences::addRecent(const char* list, const std::string& path) {
    std::error_code error;
    const auto absolute = std::filesystem::absolute(path, error).lexically_normal().string();
    if (path.empty() || error) return;
    std::vector<std::string> paths = recent(list);
    std::erase(paths, absolute);
    paths.insert(paths.begin(), absolute);
    if (paths.size() > mostRecent) paths.resize(mostRecent);
    saveRecent(list, paths);
}

void Preferences::removeRecent(const char* list, const std::string& path) {
    std::vector<std::string> paths = recent(list);
    if (std::erase(paths, path) > 0) saveRecent(list, paths);
}

void Preferences::saveRecent(const char* list, const std::vector<std::string>& paths) {
    file_.DeleteGroup(list);
    for (size_t place = 1; place <= paths.size(); ++place) {
        file_.Write(wxString::Format("%s/%zu", list, place), toWx(paths[place - 1]));
    }
    file_.Flush();
}

}  // namespace offmap::window
