// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ViewState.h"

#include <span>
#include <string>
#include <vector>

class wxConfigBase;

namespace offmap::window {

/// What the window remembers from one start to the next. Whatever is damaged in there reads as if
/// it had never been saved.
class Preferences {
 public:
    /// The file is touched by save() and the add...() functions only. \param file must outlive this
    explicit Preferences(wxConfigBase& file);

    /// \param screens [px] a window that none of them shows any more is forgotten
    ViewState load(std::span<const wxRect> screens) const;
    void save(const ViewState& state);

    /// At most 10 absolute paths, the newest first, none twice.
    std::vector<std::string> recentLogs() const { return recent("/recent_logs"); }
    std::vector<std::string> recentMaps() const { return recent("/recent_maps"); }
    void addRecentLog(const std::string& path) { addRecent("/recent_logs", path); }
    void addRecentMap(const std::string& path) { addRecent("/recent_maps", path); }
    /// Of one that is gone.
    void forgetRecentLog(const std::string& path) { removeRecent("/recent_logs", path); }
    void forgetRecentMap(const std::string& path) { removeRecent("/recent_maps", path); }

 private:
    std::vector<std::string> recent(const char* list) const;
    void addRecent(const char* list, const std::string& path);
    void removeRecent(const char* list, const std::string& path);
    void saveRecent(const char* list, const std::vector<std::string>& paths);

    wxConfigBase& file_;
};

}  // namespace offmap::window
