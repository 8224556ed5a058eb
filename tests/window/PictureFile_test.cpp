// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h"

#include "../support/TemporaryFolder.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace offmap::window {

namespace {

class PictureFileTest : public testing::Test {
 protected:
    PictureFileTest() {
        if (!wxImage::FindHandler(wxBITMAP_TYPE_PNG)) wxImage::AddHandler(new wxPNGHandler);
    }
    static std::string complaintAbout(const wxImage& picture, const std::filesystem::path& file) {
        try {
            writePicture(picture, file);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "none";
    }

    test::TemporaryFolder folder_;
};

}  // namespace

TEST_F(PictureFileTest, aPictureIsReadAsItWasWritten) {
    wxImage picture(30, 20);
    picture.SetRGB({0, 0, 30, 20}, 10, 20, 30);
    picture.SetRGB(7, 3, 200, 100, 50);
    const auto file = folder_ / "a picture.png";
    writePicture(picture, file);
    const wxImage read(file.string());
    ASSERT_TRUE(read.IsOk());
    EXPECT_EQ(read.GetSize(), wxSize(30, 20));
    EXPECT_EQ(read.GetRed(7, 3), 200);
    EXPECT_EQ(read.GetBlue(8, 3), 30);
}

TEST_F(PictureFileTest, whatCannotBeWrittenIsToldByName) {
    EXPECT_THAT(complaintAbout(wxImage(), folder_ / "none.png"), testing::HasSubstr("none.png"));
    const wxImage picture(2, 2);
    EXPECT_THAT(complaintAbout(picture, "/proc/a.png"), testing::HasSubstr("/proc/a.png"));
    test::writeFile(folder_ / "taken.png", "mine");
    EXPECT_THAT(complaintAbout(picture, folder_ / "taken.png"), testing::HasSubstr("taken.png"));
    EXPECT_EQ(test::readFile(folder_ / "taken.png"), "mine");
    EXPECT_THAT(folder_.names(), testing::ElementsAre("taken.png"));
}

}  // namespace offmap::window
