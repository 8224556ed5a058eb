// SPDX-License-Identifier: BSD-3-Clause
#include <offmap/live/WaitingPieces.h>

#include <gtest/gtest.h>

namespace offmap::live {
namespace {

TurnPiece pieceFrom(size_t packet) { return {7, packet, nullptr}; }

TEST(WaitingPieces, areTakenInTheirOrder) {
    WaitingPieces pieces;
    EXPECT_FALSE(pieces.take());
    for (const size_t packet : {0, 4, 8}) pieces.add(pieceFrom(packet));
    for (const size_t packet : {0, 4, 8}) {
        const auto piece = pieces.take();
        ASSERT_TRUE(piece);
        EXPECT_EQ(piece->firstPacket, packet);
    }
    EXPECT_FALSE(pieces.take());
}

TEST(WaitingPieces, areForgottenWhenTheirTurnHasCome) {
    WaitingPieces pieces;
    pieces.add(pieceFrom(0));
    pieces.clear();
    EXPECT_FALSE(pieces.take());
    pieces.add(pieceFrom(4));
    EXPECT_EQ(pieces.take()->firstPacket, 4U);
}

TEST(WaitingPieces, areNoMoreThanAreOfUse) {
    WaitingPieces pieces;
    for (size_t packet = 0; packet < 2 * WaitingPieces::most; ++packet) {
        pieces.add(pieceFrom(packet));
    }
    for (size_t packet = 0; packet < WaitingPieces::most; ++packet) {
        ASSERT_EQ(pieces.take()->firstPacket, packet) << "the first follow each other";
    }
    EXPECT_FALSE(pieces.take());
}

}  // namespace
}  // namespace offmap::live
