// SPDX-License-Identifier: MIT
#include "replay/foreign/lammps_dump.h"

#include "tests/replay/synthetic.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <zlib.h>

namespace bedmix::test {
namespace {

/// A snapshot in a box from -1 to 3, 0 to 2 and -2 to 2.
std::string snapshot(int step, const std::string& columns, const std::vector<std::string>& rows,
                     const std::string& time = "") {
  std::string text = time.empty() ? "" : "ITEM: TIME\n" + time + "\n";
  text += fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS ff pp mm\n"
      "-1 3\n0.0000000000000000e+00 2.0e0\n-2 2\nITEM: ATOMS {} \n",
      step, rows.size(), columns);
  for (const std::string& row : rows) text += row + " \n";
  return text;
}

class LammpsDump : public testing::Test {
 protected:
  Result<std::unique_ptr<ForeignSource>> open(const std::string& text) {
    writeText(folder_ / "dump", text);
    return openLammpsDump(std::vector{folder_ / "dump"});
  }
  /// What is said of a file that cannot be opened or whose first frame cannot be read.
  std::string problemOf(const std::string& text) {
    auto dump = open(text);
    if (!dump) return said(dump.problems.front());
    auto frame = (*dump)->frame(0);
    return frame ? "" : said(frame.problems.front());
  }
  std::string said(const Diagnostic& problem) {
    EXPECT_EQ(problem.trouble, Trouble::file);
    return toString(problem).substr(folder_.path().string().size() + 1);
  }

  TemporaryFolder folder_;
};

const std::string xyz = "id type x y z";

TEST_F(LammpsDump, HoldsWhatItSays) {
  auto dump = open(
      snapshot(0, "vx c_1 id vy type vz omegax radius y omegay z x omegaz",
               {"1 - 7 2 1 3 4 0.5 20 5 30 10 6", "-1 nan 3 -2 2 -3 -4 0.25 .5 -5 1e-3 -1.5e+1 -6"}, "0") +
      snapshot(50, "vx c_1 id vy type vz omegax radius y omegay z x omegaz", {}, "0.25"));
  ASSERT_TRUE(dump) << toString(dump.problems.front());
  EXPECT_EQ((*dump)->dimensions(), 3);
  EXPECT_EQ((*dump)->steps(), (std::vector<std::int64_t>{0, 50}));
  EXPECT_EQ((*dump)->times(), (std::vector<double>{0.0, 0.25}));
  const auto box = (*dump)->box();
  ASSERT_TRUE(box);
  EXPECT_EQ(box->low, (Vec3d{-1.0, 0.0, -2.0}));
  EXPECT_EQ(box->high, (Vec3d{3.0, 2.0, 2.0}));

  const auto frame = (*dump)->frame(0);
  ASSERT_TRUE(frame) << toString(frame.problems.front());
  EXPECT_EQ(frame->position, (std::vector<Vec3d>{{10.0, 20.0, 30.0}, {-15.0, 0.5, 1e-3}}));
  EXPECT_EQ(frame->velocity, (std::vector<Vec3d>{{1.0, 2.0, 3.0}, {-1.0, -2.0, -3.0}}));
  EXPECT_EQ(frame->angularVelocity, (std::vector<Vec3d>{{4.0, 5.0, 6.0}, {-4.0, -5.0, -6.0}}));
  EXPECT_EQ(frame->radius, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(frame->species, (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(frame->id, (std::vector<std::int64_t>{7, 3}));

  const auto none = (*dump)->frame(1);
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->position.empty());
}

TEST_F(LammpsDump, WhatItDoesNotSayIsEmpty) {
  auto dump = open(snapshot(3, "x y z vx vy omegaz", {"1 1 1 1 1 1"}));
  ASSERT_TRUE(dump);
  EXPECT_TRUE((*dump)->times().empty());
  const auto frame = (*dump)->frame(0);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->position.size(), 1u);
  EXPECT_TRUE(frame->velocity.empty());  // a third of it is not there
  EXPECT_TRUE(frame->angularVelocity.empty());
  EXPECT_TRUE(frame->radius.empty());
  EXPECT_TRUE(frame->species.empty());
  EXPECT_TRUE(frame->id.empty());
}

TEST_F(LammpsDump, InTwoDimensionsTheSpinIsAboutZ) {
  auto dump = open(snapshot(3, "omegaz y x vx vy diameter", {"6 2 1 3 4 0.5"}));
  ASSERT_TRUE(dump);
  EXPECT_EQ((*dump)->dimensions(), 2);
  const auto frame = (*dump)->frame(0);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->position, (std::vector<Vec3d>{{1.0, 2.0, 0.0}}));
  EXPECT_EQ(frame->velocity, (std::vector<Vec3d>{{3.0, 4.0, 0.0}}));
  EXPECT_EQ(frame->angularVelocity, (std::vector<Vec3d>{{0.0, 0.0, 6.0}}));
  EXPECT_EQ(frame->radius, (std::vector<double>{0.25}));
}

TEST_F(LammpsDump, EveryFormOfCoordinatesIsThePosition) {
  const auto position = [&](const std::string& columns, const std::string& row) {
    auto dump = open(snapshot(0, columns, {row}));
    const auto frame = (*dump)->frame(0);
    return frame ? frame->position.at(0) : Vec3d{};
  };
  EXPECT_EQ(position("xu yu zu", "7 8 9"), (Vec3d{7.0, 8.0, 9.0}));  // beyond the box: unwrapped
  EXPECT_EQ(position("xs ys zs", "0 0.25 1"), (Vec3d{-1.0, 0.5, 2.0}));
  EXPECT_EQ(position("xsu ysu zsu", "1.5 -0.25 2"), (Vec3d{5.0, -0.5, 6.0}));
  EXPECT_EQ(position("xs ys", "0 0.25"), (Vec3d{-1.0, 0.5, 0.0}));
  EXPECT_EQ(position("xs x ys y zs z", "0 7 0 8 0 9"), (Vec3d{7.0, 8.0, 9.0}));
}

TEST_F(LammpsDump, ParticlesMayComeAndGo) {
  auto dump =
      open(snapshot(0, xyz, {"1 1 0 0 0"}) + snapshot(10, xyz, {"2 1 0 0 0", "1 1 1 0 0", "9 2 2 0 0"}) +
           snapshot(20, xyz, {"9 2 4 0 0"}));
  ASSERT_TRUE(dump);
  EXPECT_EQ((*dump)->frame(2)->id, (std::vector<std::int64_t>{9}));  // in any order
  EXPECT_EQ((*dump)->frame(0)->id, (std::vector<std::int64_t>{1}));
  EXPECT_EQ((*dump)->frame(1)->id, (std::vector<std::int64_t>{2, 1, 9}));
}

TEST_F(LammpsDump, FilesOfASeriesAreTakenByTheirSteps) {
  std::vector<std::filesystem::path> paths;
  for (const int step : {1000, 200, 30}) {
    paths.push_back(folder_ / ("dump." + std::to_string(step)));
    writeText(paths.back(), snapshot(step, xyz, {fmt::format("1 1 {} 0 0", step)}) +
                                snapshot(step + 1, xyz, {fmt::format("1 1 {} 0 0", step + 1)}));
  }
  paths.push_back(folder_ / "dump.1100");  // begun, and nothing in it yet
  writeText(paths.back(), "");
  auto dump = openLammpsDump(paths);
  ASSERT_TRUE(dump) << toString(dump.problems.front());
  const std::vector<std::int64_t> steps{30, 31, 200, 201, 1000, 1001};
  EXPECT_EQ((*dump)->steps(), steps);
  for (const std::size_t i : {5, 0, 3, 2, 1, 4})
    EXPECT_EQ((*dump)->frame(i)->position.at(0)[0], static_cast<double>(steps[i]));

  writeText(paths.back(), snapshot(200, xyz, {}));
  dump = openLammpsDump(paths);
  ASSERT_FALSE(dump);
  EXPECT_NE(toString(dump.problems.front()).find("begins with step 200, as does"), std::string::npos);
}

TEST_F(LammpsDump, WhatAResumedRunWritesAnewCounts) {
  const std::string killed = snapshot(300, xyz, {"1 1 3 0 0", "2 1 3 0 0"});
  const std::size_t oneRow = killed.find("2 1 3");
  auto dump =
      open(snapshot(100, xyz, {"1 1 1 0 0"}) + snapshot(200, xyz, {"1 1 2 0 0"}) + killed.substr(0, oneRow) +
           snapshot(200, xyz, {"1 1 -2 0 0"}) + snapshot(300, xyz, {"1 1 -3 0 0"}));
  ASSERT_TRUE(dump) << toString(dump.problems.front());
  EXPECT_EQ((*dump)->steps(), (std::vector<std::int64_t>{100, 200, 300}));
  EXPECT_EQ((*dump)->frame(0)->position.at(0)[0], 1.0);
  EXPECT_EQ((*dump)->frame(1)->position.at(0)[0], -2.0);
  EXPECT_EQ((*dump)->frame(2)->position.at(0)[0], -3.0);

  EXPECT_EQ(problemOf(killed.substr(0, oneRow) + snapshot(400, xyz, {})),
            "dump:11:1: step 300 has 1 of its 2 particles");
}

TEST_F(LammpsDump, GzippedIsTheSame) {
  std::string text;
  for (int step = 0; step < 300; ++step) {
    std::vector<std::string> rows;
    for (int i = 0; i < 50; ++i) rows.push_back(fmt::format("{} 1 {} 0 0", i, step + i));
    text += snapshot(step, xyz, rows);
  }
  const std::filesystem::path path = folder_ / "dump.gz";
  const gzFile file = gzopen(path.c_str(), "wb");
  ASSERT_EQ(gzwrite(file, text.data(), static_cast<unsigned>(text.size())), static_cast<int>(text.size()));
  gzclose(file);
  auto dump = openLammpsDump(std::vector{path});
  ASSERT_TRUE(dump) << toString(dump.problems.front());
  ASSERT_EQ((*dump)->steps().size(), 300u);
  for (const std::size_t i : {0, 299, 150, 151})
    EXPECT_EQ((*dump)->frame(i)->position.at(7)[0], static_cast<double>(i) + 7);

  const std::string packed = fileText(path);
  writeText(path, packed.substr(0, packed.size() / 2));  // killed
  dump = openLammpsDump(std::vector{path});
  ASSERT_TRUE(dump) << toString(dump.problems.front());
  const std::size_t whole = (*dump)->steps().size();
  EXPECT_GT(whole, 100u);
  EXPECT_LT(whole, 200u);
  EXPECT_EQ((*dump)->frame(whole - 1)->position.at(7)[0], static_cast<double>(whole - 1) + 7);
}

/// Grains that fall into a box; dumped before there are any and four times after.
constexpr const char* liggghtsDeck = R"(atom_style granular
boundary f f f
newton off
communicate single vel yes
units si
region reg block 0 0.02 0 0.02 0 0.05 units box
create_box 1 reg
neighbor 0.001 bin
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
fix g all gravity 9.81 vector 0 0 -1
fix zw all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix xl all wall/gran model hertz tangential history primitive type 1 xplane 0.0
fix xr all wall/gran model hertz tangential history primitive type 1 xplane 0.02
fix yl all wall/gran model hertz tangential history primitive type 1 yplane 0.0
fix yr all wall/gran model hertz tangential history primitive type 1 yplane 0.02
fix pts all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.001
fix pdd all particledistribution/discrete 15485867 1 pts 1.0
fix ins all insert/pack seed 32452843 distributiontemplate pdd vel constant 0 0 -0.1 insert_every once overlapcheck yes all_in yes particles_in_region 60 region reg
fix integ all nve/sphere
dump d all custom 500 post.dump id type x y z vx vy vz omegax omegay omegaz radius
run 2000
)";

TEST_F(LammpsDump, OfLiggghtsItself) {
  if (std::system("command -v liggghts > /dev/null") != 0) GTEST_SKIP() << "needs Debian's liggghts";
  writeText(folder_ / "in.bed", liggghtsDeck);
  ASSERT_EQ(std::system(
                ("cd " + folder_.path().string() + " && liggghts -in in.bed > out 2>&1 < /dev/null").c_str()),
            0)
      << fileText(folder_ / "out");
  auto dump = openLammpsDump(std::vector{folder_ / "post.dump"});
  ASSERT_TRUE(dump) << toString(dump.problems.front());
  EXPECT_EQ((*dump)->steps(), (std::vector<std::int64_t>{0, 500, 1000, 1500, 2000}));
  EXPECT_TRUE((*dump)->frame(0)->position.empty());
  const auto frame = (*dump)->frame(3);
  ASSERT_TRUE(frame);
  ASSERT_EQ(frame->position.size(), 60u);

  // The rows as any program would find them: by the fourth header, twelve numbers each.
  std::istringstream lines(fileText(folder_ / "post.dump"));
  std::string line;
  for (int headers = 0; headers < 4;)
    if (std::getline(lines, line); line.starts_with("ITEM: ATOMS")) ++headers;
  for (std::size_t i = 0; i < 60; ++i) {
    std::int64_t id = 0, type = 0;
    Vec3d x, v, w;
    double radius = 0.0;
    lines >> id >> type >> x[0] >> x[1] >> x[2] >> v[0] >> v[1] >> v[2] >> w[0] >> w[1] >> w[2] >> radius;
    EXPECT_EQ(frame->id[i], id);
    EXPECT_EQ(frame->species[i], type);
    EXPECT_EQ(frame->position[i], x);
    EXPECT_EQ(frame->velocity[i], v);
    EXPECT_EQ(frame->angularVelocity[i], w);
    EXPECT_EQ(frame->radius[i], radius);
  }
}

TEST_F(LammpsDump, CutOffAnywhereItHasFewerFrames) {
  const std::string first = snapshot(0, xyz, {"1 1 0.125 2 3", "2 1 4 5 6"}, "0");
  const std::string text = first + snapshot(10, xyz, {"1 2 0.125 2 3", "2 1 4 5 625"}, "0.5");
  for (std::size_t size = 0; size <= text.size(); ++size) {
    auto dump = open(text.substr(0, size));
    ASSERT_EQ(bool(dump), size >= first.size()) << size;
    if (!dump) continue;
    ASSERT_EQ((*dump)->steps().size(), size < text.size() ? 1u : 2u) << size;
    const auto frame = (*dump)->frame((*dump)->steps().size() - 1);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->position.at(1), size < text.size() ? (Vec3d{4.0, 5.0, 6.0}) : (Vec3d{4.0, 5.0, 625.0}));
  }
}

TEST_F(LammpsDump, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(problemOf(snapshot(0, xyz, {"1 1 0 0 0", "2 1 0 nan 0"})), "dump:11:7: 'nan' is not a number");
  EXPECT_EQ(problemOf(snapshot(0, xyz, {"1 1 0 0 0", "2 1 0 1e999 0"})),
            "dump:11:7: '1e999' is not a number");
  EXPECT_EQ(problemOf(snapshot(0, xyz, {"1 1 0 0,5 0"})), "dump:10:7: '0,5' is not a number");
  EXPECT_EQ(problemOf(snapshot(0, xyz, {"1.5 1 0 0 0"})), "dump:10:1: '1.5' is not a whole number");
  EXPECT_EQ(problemOf(snapshot(0, xyz, {"1 1 0 0"})).find("dump:10:1: the row has fewer columns"), 0u);
  EXPECT_EQ(problemOf(snapshot(0, xyz, {"1 1 0 0 0 8"})), "dump:10:11: '8' stands where the line should end");
  EXPECT_EQ(problemOf(snapshot(0, xyz, {"1 1 0 0 0", "1 1 1 1 1"})),
            "dump:10:1: the id 1 stands more than once in step 0");
  EXPECT_EQ(problemOf(snapshot(0, "xs ys zs", {"0 1e308 0"})),
            "dump:10:1: the particle is infinitely far from its box");
  EXPECT_EQ(problemOf(snapshot(0, "id type", {"1 1"})).find("dump:9:1: the snapshot has no columns x and y"),
            0u);
  EXPECT_EQ(
      problemOf(snapshot(0, xyz, {}) + snapshot(1, "x y", {})).find("dump:18:1: the columns are others"), 0u);
  EXPECT_EQ(problemOf(snapshot(0, xyz, {}, "1") + snapshot(1, xyz, {}, "1")),
            "dump:23:1: step 1 has the time 1 s, the one before it 1 s");
  EXPECT_EQ(problemOf("ITEM: UNITS\nlj\n" + snapshot(0, xyz, {})),
            "dump:2:1: units are 'lj'; only si is read");
  EXPECT_EQ(problemOf("ITEM: UNITS\nsi\n" + snapshot(0, xyz, {})), "");
  EXPECT_EQ(problemOf("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n0\n")
                .find("dump:3:1: 'NUMBER OF ENTRIES' is not"),
            0u);
  EXPECT_EQ(problemOf("ITEM: TIMESTEP\n0\nITEM: ATOMS x y\n").find("dump:3:1: particles without a step"), 0u);
  EXPECT_EQ(problemOf("ITEM: NUMBER OF ATOMS\n-1\n"), "dump:2:1: '-1' is not a whole number");
  EXPECT_EQ(problemOf("ITEM: BOX BOUNDS xy xz yz pp pp pp\n"),
            "dump:1:1: the box is triclinic; only orthogonal ones are read");
  const std::string few = snapshot(0, xyz, {"1 1 0 0 0", "2 1 0 0 0"});
  EXPECT_EQ(problemOf(few + "3 1 0 0 0\n"),
            "dump:12:1: '3 1 0 0 0' stands where an ITEM: should; the file is damaged");
}

TEST_F(LammpsDump, OtherFilesAreRefused) {
  EXPECT_EQ(problemOf(""), "dump: holds no whole snapshot of a LAMMPS dump");
  EXPECT_NE(problemOf("x,y\n1,2\n").find("no text dump of LAMMPS"), std::string::npos);
  EXPECT_NE(problemOf(std::string(3 << 20, '\0')).find("is no text"), std::string::npos);
  EXPECT_NE(
      problemOf("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n4000000000\nITEM: BOX BOUNDS\n0 1\n0 1\n0 1\n"
                "ITEM: ATOMS x y\n0 0\n")
          .find("no whole snapshot"),
      std::string::npos);
  EXPECT_FALSE(openLammpsDump(std::vector{folder_ / "none"}));
  EXPECT_FALSE(openLammpsDump(std::vector{folder_.path()}));
  EXPECT_FALSE(openLammpsDump({}));
}

}  // namespace
}  // namespace bedmix::test
