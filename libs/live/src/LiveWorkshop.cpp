// SPDX-License-Identifier: BSD-3-Clause
#include "LiveWorkshop.h"

#include <offmap/rawlog/ScanClasses.h>

#include <utility>

namespace offmap::live {

LiveWorkshop::LiveWorkshop(LiveSetup setup)
    : setup_(std::move(setup)),
      sensors_(setup_.config),
      reducer_(*setup_.map, *setup_.poses, setup_.config, setup_.output) {}

const rawlog::ScanClass* LiveWorkshop::scanClassOf(const rawlog::Turn& turn) {
    return rawlog::scanClassOf(*turn.front(), sensors_.of(turn.front()->sensorLabel));
}

void LiveWorkshop::take(const TurnPiece& piece) {
    if (!progress_.add(piece)) return;
    const rawlog::Turn soFar = progress_.turn();
    const rawlog::ScanClass* scanClass = scanClassOf(soFar);
    if (!scanClass) return progress_.clear();
    if (piece.firstPacket == 0) reducer_.begin(*scanClass);
    reducer_.add(soFar);
}

rawlog::ReducedTurn LiveWorkshop::reduce(const rawlog::Turn& turn) {
    if (!progress_.begins(turn)) reducer_.begin(*scanClassOf(turn));
    progress_.clear();
    return reducer_.finish(turn);
}

}  // namespace offmap::live
