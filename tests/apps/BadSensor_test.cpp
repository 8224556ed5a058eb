// SPDX-License-Identifier: BSD-3-Clause
#include "ReduceFixture.h"

// Options and keys of single sensors that cannot be meant.

namespace {

using namespace offmap::test;
using testing::AllOf;
using testing::HasSubstr;

class BadSensor : public ReduceFixture {
 protected:
    BadSensor() {
        SimulatedRobot robot;
        writeLog(in_, oneSecondOf(robot));
    }

    template <class Matcher>
    void expectRefused(const Arguments& more, const Matcher& message) const {
        expectRefusal(reduceArguments(more), 1, message);
    }

    template <class Matcher>
    void expectConfigRefused(const std::string& yaml, const Matcher& message) const {
        const Path config = folder_ / "own.yaml";
        writeFile(config, yaml);
        expectRefused({"--config", config}, AllOf(HasSubstr(config.string() + ":"), message));
    }
};

TEST_F(BadSensor, poseOfAnotherFormTellsTheForm) {
    const auto form = HasSubstr("x,y,z,yaw_deg,pitch_deg,roll_deg");
    for (const char* pose : {"", "CLOUD", "0,0,1,0,0,0", "CLOUD=", "CLOUD=0,0,1,0,0",
                             "CLOUD=0,0,1,0,0,0,0", "CLOUD=0,0,1,0,0,north", "CLOUD=0,0,nan,0,0,0",
                             "CLOUD=0,0,1,0,0,1e999", "CLOUD=0 0 1 0 0 0", "CLOUD=0,0,1,0,0,0,"}) {
        SCOPED_TRACE(pose);
        expectRefused({"--sensor-pose", pose}, AllOf(HasSubstr("--sensor-pose"), form));
    }
}

TEST_F(BadSensor, secondPoseOfASensorIsRefused) {
    expectRefused({"--sensor-pose", "CLOUD=0,0,1,0,0,0", "--sensor-pose", "CLOUD=0,0,1,0,0,0"},
                  AllOf(HasSubstr("'CLOUD'"), HasSubstr("second")));
}

TEST_F(BadSensor, poseOfWhatHasNoScanListsWhatHas) {
    for (const char* label : {"CLUOD", "IMU", "FRONT_LASER", "LOCALIZATION", ""}) {
        SCOPED_TRACE(label);
        expectRefused({"--sensor-pose", std::string(label) + "=0,0,1,0,0,0"},
                      AllOf(HasSubstr("'" + std::string(label) + "'"), HasSubstr("CLOUD"),
                            HasSubstr("VLP16"), HasSubstr(in_.string())));
    }
}

TEST_F(BadSensor, poseOfATurnedScannerIsRefused) {
    expectRefused({"--sensor-pose", "SWEEP=0,0,1,0,0,0"},
                  AllOf(HasSubstr("'SWEEP'"), HasSubstr("turned 2D scanner")));
}

TEST_F(BadSensor, poseIsRefusedByRenderAlike) {
    const Arguments render{"render", in_, "--map", map_, "-o", folder_ / "a.png", "--sensor-pose"};
    for (const char* pose : {"CLOUD=1", "IMU=0,0,1,0,0,0", "SWEEP=0,0,1,0,0,0"}) {
        Arguments all = render;
        all.emplace_back(pose);
        expectRefusal(all, 1, HasSubstr(std::string(pose).substr(0, 3)));
    }
}

TEST_F(BadSensor, wrongSettingTellsWhatIsAllowed) {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"time_reference=noon", "first, middle, last"},
        {"elevations_deg=[1,2", "a list of numbers"},
        {"elevations_deg=up", "-90 ... 90 deg"},
        {"elevations_deg=91", "-90 ... 90 deg"},
        {"elevations_deg=", "a list of numbers"},
        {"min_range_m=-0.5", "0 ... 100 m"},
        {"min_range_m=nan", "0 ... 100 m"},
        {"robot_box_m=1,2,3", "0 or 6 numbers"},
        {"robot_box_m=-1,1,-1,1,0,1000", "-100 ... 100 m"},
        {"robot_box_m=1,-1,-1,1,0,1", "min less than its max"}};
    for (const auto& [setting, allowed] : wrong) {
        SCOPED_TRACE(setting);
        const std::string name = setting.substr(0, setting.find('='));
        expectRefused({"--set", "sensor." + setting}, AllOf(HasSubstr(name), HasSubstr(allowed)));
        expectRefused({"--set", "sensors.CLOUD." + setting},
                      AllOf(HasSubstr("CLOUD"), HasSubstr(name), HasSubstr(allowed)));
    }
}

TEST_F(BadSensor, wrongEntryInAFileTellsItsLine) {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"time_reference: 1", "first, middle, last"},
        {"time_reference: [first]", "first, middle, last"},
        {"elevations_deg: {row: 1}", "a list of numbers"},
        {"elevations_deg: [1, 91]", "-90 ... 90 deg"},
        {"min_range_m: [1]", "0 ... 100 m"},
        {"min_range_m: near", "0 ... 100 m"},
        {"robot_box_m: [1, 2]", "0 or 6 numbers"},
        {"robot_box_m:", "0 or 6 numbers"}};
    for (const auto& [entry, allowed] : wrong) {
        SCOPED_TRACE(entry);
        const auto message = AllOf(HasSubstr(entry.substr(0, entry.find(':'))), HasSubstr(allowed));
        expectConfigRefused("sensor:\n  " + entry + "\n", AllOf(HasSubstr(":2:"), message));
        expectConfigRefused("sensors:\n  CLOUD:\n    " + entry + "\n",
                            AllOf(HasSubstr(":3:"), message));
    }
}

TEST_F(BadSensor, unknownNameSuggestsTheNearest) {
    expectRefused({"--set", "sensors.CLOUD.min_rang=1"}, HasSubstr("did you mean min_range_m?"));
    expectRefused({"--set", "sensors.min_range_m=1"}, HasSubstr("sensors.LABEL.min_range_m"));
    expectRefused({"--set", "sensors.CLOUD.min_range_m"}, HasSubstr("lacks its value"));
    expectConfigRefused("sensors:\n  CLOUD:\n    min_rang: 1\n",
                        AllOf(HasSubstr(":3:"), HasSubstr("did you mean min_range_m?")));
    expectConfigRefused("sensors:\n  min_range_m: 1\n", HasSubstr("under their labels"));
}

}  // namespace
