// SPDX-License-Identifier: MIT
#include "tests/app/program.h"

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

class CommandsExport : public ProgramTest {};

TEST_F(CommandsExport, EachFormatSaysWhatItHasWritten) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "out"}).exitCode, 0);
  for (const char* format : {"vtk", "xdmf", "csv", "extxyz", "lammps"}) {
    const Outcome o = bedmix(
        {"export", "out", "--to", format, "-o", format, "--from", "0.02", "--until", "0.04", "--json"});
    ASSERT_EQ(o.exitCode, 0) << o.err;
    const auto said = nlohmann::json::parse(o.out);
    EXPECT_EQ(said["frames"], 3);
    EXPECT_EQ(said["from"], 0.02);
    EXPECT_EQ(said["until"], 0.04);
    for (const std::string file : said["files"]) EXPECT_TRUE(fs::exists(folder / file)) << file;
    const Outcome again = bedmix({"export", "out", "--to", format, "-o", format});
    EXPECT_EQ(again.exitCode, 4);
    EXPECT_TRUE(contains(again.err, "is there already"));
  }
  EXPECT_TRUE(
      contains(readFile(folder / "vtk/particles.pvd"), "timestep=\"0.02\" file=\"particles_000002.vtp\""));
  EXPECT_TRUE(
      contains(readFile(folder / "xdmf/particles.xmf"), ">../out/trajectory.h5:/particles/all/position"));
  // The descriptions may lie beside the trajectory.
  EXPECT_EQ(bedmix({"export", "out", "--to", "xdmf", "-o", "out"}).exitCode, 0);
  EXPECT_TRUE(contains(readFile(folder / "out/gas.xmf"), ">trajectory.h5:/bedmix/gas/voidage/value<"));
}

TEST_F(CommandsExport, WhatBeginsLateIsDrawnFromThere) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "out"}).exitCode, 0);
  ASSERT_EQ(bedmix({"export", "out", "--to", "lammps", "-o", "dump", "--from", "0.03"}).exitCode, 0);
  const std::string dump = "dump/particles.lammpstrj";
  const Outcome sheet = bedmix({"sheet", dump, "-o", "late.png"});
  EXPECT_EQ(sheet.exitCode, 0) << sheet.err;
  const Outcome report = bedmix({"report", dump, "-o", "late"});
  EXPECT_EQ(report.exitCode, 0) << report.err;
  EXPECT_EQ(bedmix({"sheet", dump, "-o", "early.png", "--times", "0"}).exitCode, 2);
}

TEST_F(CommandsExport, WhatIsWrongIsNamed) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "out"}).exitCode, 0);
  const Outcome unknown = bedmix({"export", "out", "--to", "vkt", "-o", "x"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_TRUE(contains(unknown.err, "--to: there is no format \"vkt\"; did you mean \"vtk\"?"));
  const Outcome empty = bedmix({"export", "out", "--to", "csv", "-o", "x", "--from", "3"});
  EXPECT_EQ(empty.exitCode, 2);
  EXPECT_TRUE(contains(empty.err, "--from/--until"));
  EXPECT_EQ(bedmix({"export", "none", "--to", "csv", "-o", "x"}).exitCode, 4);
  EXPECT_FALSE(fs::exists(folder / "x"));
}

class CommandsRecover : public ProgramTest {
 protected:
  std::string hashOf(const std::string& run) const {
    return nlohmann::json::parse(readFile(folder / run / "summary.json"))["state_hash"];
  }
};

TEST_F(CommandsRecover, ARunGoesOnFromWhatIsSaved) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "out", "--until", "0.5", "--checkpoint", "0.1"}).exitCode, 0);
  const std::string whole = readFile(folder / "out/trajectory.h5");
  // A frame in the middle is lost, the checkpoints are later: no run can go on, but what came before is
  // there.
  fs::create_directory(folder / "cut");
  writeFile(folder / "cut/trajectory.h5", whole.substr(0, whole.size() / 2));
  ASSERT_EQ(bedmix({"replay", "cut"}).exitCode, 4);
  const Outcome cut = bedmix({"recover", "cut", "--json"});
  ASSERT_EQ(cut.exitCode, 0) << cut.err;
  const auto said = nlohmann::json::parse(cut.out);
  EXPECT_EQ(said["sound"], false);
  EXPECT_EQ(said["output"], "cut/trajectory-recovered.h5");
  EXPECT_EQ(said["recorded"], 51);
  EXPECT_EQ(bedmix({"replay", "cut/trajectory-recovered.h5", "-o", "again"}).exitCode, 0);
  EXPECT_EQ(bedmix({"recover", "cut"}).exitCode, 4);  // it is there already
  const std::string again = readFile(folder / "again/mixing.csv");
  EXPECT_TRUE(readFile(folder / "out/mixing.csv").starts_with(again) && !again.empty());

  // Flags no bedmix sets: HDF5 refuses the file, though all is there.
  std::string flagged = whole;
  flagged[20] = '\xf0';
  writeFile(folder / "flagged.h5", flagged);
  ASSERT_EQ(bedmix({"recover", "flagged.h5", "-o", "saved/trajectory.h5"}).exitCode, 0);
  const Outcome resumed = bedmix({"run", "tiny", "-o", "saved", "--until", "0.6", "--resume"});
  ASSERT_EQ(resumed.exitCode, 0) << resumed.err;
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "longer", "--until", "0.6"}).exitCode, 0);
  EXPECT_EQ(hashOf("saved"), hashOf("longer"));
  EXPECT_EQ(readFile(folder / "saved/mixing.csv"), readFile(folder / "longer/mixing.csv"));
}

TEST_F(CommandsRecover, ASoundFileIsSaidToBe) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "out"}).exitCode, 0);
  const Outcome o = bedmix({"recover", "out", "--json"});
  EXPECT_EQ(o.exitCode, 0);
  EXPECT_TRUE(contains(o.err, "is sound, nothing to repair"));
  const auto said = nlohmann::json::parse(o.out);
  EXPECT_EQ(said["sound"], true);
  EXPECT_EQ(said["output"], nullptr);
  EXPECT_EQ(said["frames"], 6);
  EXPECT_FALSE(fs::exists(folder / "out/trajectory-recovered.h5"));
  EXPECT_EQ(bedmix({"recover", "none.h5"}).exitCode, 4);
}

}  // namespace
}  // namespace bedmix
