// SPDX-License-Identifier: BSD-3-Clause
#include "Instrument.h"

#include <offmap/rawlog/ConfigFile.h>

namespace offmap::accuracy {

std::string_view nameOf(core::MatchingMethod method) {
    switch (method) {
        case core::MatchingMethod::Paper:
            return "paper";
        case core::MatchingMethod::Probabilistic:
            return "probabilistic";
        default:
            return "aligned";
    }
}

std::vector<Instrument> instruments() {
    rawlog::Config ofVlp16;
    rawlog::applyYaml(ofVlp16, OFFMAP_SOURCE_DIR "/config/vlp16.yaml");
    return {{"181 x 181", evaluation::paperScanner(), rawlog::Config().reduction},
            {"VLP-16", evaluation::vlp16(), ofVlp16.reduction}};
}

}  // namespace offmap::accuracy
