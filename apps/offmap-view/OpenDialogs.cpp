// SPDX-License-Identifier: BSD-3-Clause
#include "OpenDialogs.h"

#include <gtk/gtk.h>

namespace offmap::window {

bool OpenDialogs::cancelOne() {
    if (dialogs_.empty()) return false;
    wxDialog* dialog = dialogs_.back();
    if (dialog->IsModal()) {
        dialog->EndModal(wxID_CANCEL);
    } else if (GTK_IS_DIALOG(dialog->GetHandle())) {  // one that GTK runs by itself
        gtk_dialog_response(GTK_DIALOG(dialog->GetHandle()), GTK_RESPONSE_CANCEL);
    }
    return true;
}

int OpenDialogs::Enter(wxDialog* dialog) {
    dialogs_.push_back(dialog);
    return wxID_NONE;
}

void OpenDialogs::Exit(wxDialog* dialog) { std::erase(dialogs_, dialog); }

}  // namespace offmap::window
