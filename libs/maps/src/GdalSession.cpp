// SPDX-License-Identifier: BSD-3-Clause
#include "GdalSession.h"

#include "PrintableName.h"

#include <algorithm>
#include <cpl_conv.h>
#include <cpl_http.h>
#include <string_view>
#include <utility>

namespace offmap::maps {

namespace {

constexpr std::pair<const char*, const char*> settings[] = {
    // [deg] chord error below 2 mm up to a radius of 200 m
    {"OGR_ARC_STEPSIZE", "0.5"},
    // each piece of a block keeps its own layer and class
    {"DXF_MERGE_BLOCK_GEOMETRIES", "FALSE"},
    // a whole plan may be one block; blocks in blocks must not fill the memory
    {"DXF_FEATURE_LIMIT_PER_BLOCK", "200000"},
    {"GML_SKIP_RESOLVE_ELEMS", "ALL"},
    {"SHAPE_RESTORE_SHX", "NO"},
    // a schema may name a file in the net
    {"CPL_VSIL_CURL_ALLOWED_FILENAME", "none"},
};

/// A coordinate reference system may be given as an address in the net.
CPLHTTPResult* refuse(const char*, CSLConstList, GDALProgressFunc, void*, CPLHTTPFetchWriteFunc,
                      void*, void*) {
    auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
    result->nStatus = 1;
    result->pszErrBuf = CPLStrdup("a map is not fetched from the net");
    return result;
}

}  // namespace

GdalSession::GdalSession() {
    CPLPushErrorHandlerEx(&GdalSession::listen, this);
    CPLHTTPPushFetchCallback(&refuse, nullptr);
    for (const auto& [key, value] : settings) CPLSetThreadLocalConfigOption(key, value);
}

GdalSession::~GdalSession() {
    for (const auto& [key, value] : settings) CPLSetThreadLocalConfigOption(key, nullptr);
    CPLHTTPPopFetchCallback();
    CPLPopErrorHandler();
}

std::string GdalSession::why(const std::string& instead) const {
    if (!failures_.empty()) return failures_.back();
    return warnings_.empty() ? instead : warnings_.back();
}

void GdalSession::listen(CPLErr severity, CPLErrorNum, const char* message) {
    if (severity == CE_None || severity == CE_Debug) return;
    // a face of a DXF, which GDAL closes after it has said so
    if (std::string_view(message).starts_with("Non closed ring")) return;
    constexpr size_t most = 1000;
    auto& session = *static_cast<GdalSession*>(CPLGetErrorHandlerUserData());
    auto& heard = severity == CE_Warning ? session.warnings_ : session.failures_;
    std::string sentence = printableName(message, 300);
    if (heard.size() < most && std::ranges::find(heard, sentence) == heard.end()) {
        heard.push_back(std::move(sentence));
    }
}

}  // namespace offmap::maps
