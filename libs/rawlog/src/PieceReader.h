// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <offmap/rawlog/InputFile.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

struct inflate_state;

namespace offmap::rawlog {

class MemberCutter;

/// A stretch of a file; empty where the file ends for now or has failed.
struct FilePiece {
    std::vector<unsigned char> bytes;   ///< unpacked
    std::vector<unsigned char> packed;  ///< what has still to be unpacked, if anything has
    uint64_t compressedPosition = 0;    ///< [byte] of the file, as far as it was read for this
    std::string failure;                ///< why nothing can be read after this; empty if it can
};

/// Reads and unpacks a file, plain or gzip, piece by piece.
class PieceReader {
 public:
    /// \param times that unpacking is added to; may be null
    /// \throw std::runtime_error naming the file, the cause and the fix.
    PieceReader(const std::filesystem::path& file, InputFile::WaitForMore waitForMore,
                StageTimes* times);
    ~PieceReader();

    /// Whole members of a gzip file are read packed from now on, where they can be told.
    /// \pre nothing has been read
    void cutMembers();

    /// Replaces what is in the piece by what comes next.
    void read(FilePiece& piece);

    /// Unpacks what is packed, in any thread. \return false if that is no member by itself
    bool unpack(FilePiece& piece) const;

    /// Reads on from some byte of the file, where a member begins, and unpacks what is read.
    void goOnUncut(uint64_t position);

    bool isGzip() const { return inflate_ != nullptr; }
    uint64_t compressedSize() const { return compressedSize_; }  ///< [byte] of the file

 private:
    bool cut(FilePiece& piece);
    size_t readPlain(std::span<unsigned char> to);
    size_t readCompressed(std::span<unsigned char> to);
    size_t readInflated(std::span<unsigned char> to);
    bool beginMember();
    bool haveInput();

    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    InputFile::WaitForMore waitForMore_;
    StageTimes* times_;
    std::unique_ptr<inflate_state, void (*)(inflate_state*)> inflate_;  ///< null: it is plain
    std::vector<unsigned char> compressed_;
    size_t sniffed_ = 0;  ///< [byte] of compressed_ that began a plain file and are not read yet
    bool inMember_ = false, firstMember_ = true;
    std::unique_ptr<MemberCutter> cutter_;  ///< null: pieces are read unpacked
    std::string failure_;
    uint64_t compressedPosition_ = 0, compressedSize_ = 0;
};

}  // namespace offmap::rawlog
