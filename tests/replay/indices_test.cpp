// SPDX-License-Identifier: MIT
#include "replay/analysis/indices.h"

#include "engine/core/index_band.h"
#include "engine/core/neighbour_index.h"
#include "replay/analysis/band.h"
#include "replay/analysis/sampling_size.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bedmix {
namespace {

using test::syntheticFrame;

/// Frames 0 to `frames` - 1 of a small bed whose cells hold a few particles each.
class IndexAnalyses : public testing::Test {
 protected:
  IndexAnalyses() {
    scene_.sampling.columns = 3;
    scene_.sampling.rows = 6;
    scene_.sampling.minParticles = 4;
  }
  template <class A>
  A fed(int frames) const {
    A analysis(AnalysisInput{scene_, static_cast<std::size_t>(frames), 0.01});
    for (int i = 0; i < frames; ++i) analysis.accept(syntheticFrame(scene_, i));
    return analysis;
  }

  Scene scene_ = test::syntheticScene(false, false, 400);
};

TEST_F(IndexAnalyses, TableHoldsAllIndicesOfEachFrame) {
  const auto tables = fed<Indices>(7).tables();
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].name, "indices");
  const Table& table = tables[0].table;
  ASSERT_EQ(table.names.size(), mixingIndices().size() + 2);
  ASSERT_EQ(table.rows(), 7u);
  const SamplingGrid grid = samplingGrid(scene_);
  const StartCorrelation start(syntheticFrame(scene_, 0));
  for (int i = 0; i < 7; ++i) {
    const Frame frame = syntheticFrame(scene_, i);
    const auto row = static_cast<std::size_t>(i);
    const MixingSample sample = mixingSample(frame, grid);
    EXPECT_EQ((*table.find("time"))[row], frame.time);
    EXPECT_TRUE(sample.lacey);
    EXPECT_EQ((*table.find("lacey"))[row], sample.lacey);  // that of mixing.csv, to the bit
    EXPECT_EQ((*table.find("ashton"))[row], sample.ashton);
    EXPECT_EQ((*table.find("nearest_neighbour"))[row], neighbourIndex(frame));
    EXPECT_EQ((*table.find("principal_component"))[row], start.with(frame)->index);
  }
  EXPECT_NEAR(*(*table.find("principal_component"))[0], 1.0, 1e-12);
}

TEST_F(IndexAnalyses, FindingsAreMeansOfTheSecondHalf) {
  const Indices analysis = fed<Indices>(7);
  const Table table = analysis.tables()[0].table;
  const Table::Column& rose = *table.find("rose");
  for (const FoundNumber& f : analysis.findings()) {
    if (f.name != "rose_second_half") continue;
    EXPECT_NEAR(*f.value, (*rose[3] + *rose[4] + *rose[5] + *rose[6]) / 4, 1e-14);
  }
  EXPECT_EQ(analysis.findings().size(), mixingIndices().size() + 2);
  EXPECT_EQ(analysis.findings().back().name, "time_to_ashton_0.9_over_0.1_s");
}

TEST(TimeToReach, IsThatOfTheMeanOverTheWindowAround) {
  Table::Column times, ramp, spike, gaps;
  for (int i = 0; i <= 200; ++i) {
    times.push_back(0.01 * i);
    ramp.push_back(0.01 * i);
    spike.push_back(i == 50 ? 5.0 : i == 150 ? 1.0 : i > 150);
    gaps.push_back(i % 2 ? std::optional<double>() : 0.01 * i);
  }
  EXPECT_NEAR(*timeToReach(times, ramp, 0.9, 0.1), 0.9, 0.011);  // a ramp's mean is its middle
  EXPECT_NEAR(*timeToReach(times, gaps, 0.9, 0.1), 0.9, 0.011);
  EXPECT_NEAR(*timeToReach(times, spike, 0.9, 0.1), 1.54, 1e-12);  // one sample of 5 in 11 is not a mixed bed
  EXPECT_NEAR(*timeToReach(times, spike, 0.9, 0.0), 0.5, 1e-12);
  EXPECT_FALSE(timeToReach(times, ramp, 1.99, 0.1));  // its window would end after the run
  EXPECT_FALSE(timeToReach({}, {}, 0.9, 0.1));
  EXPECT_EQ(timeToReach({0.0}, {1.0}, 0.9, 0.1), std::nullopt);
  EXPECT_EQ(timeToReach({0.0}, {1.0}, 0.9, 0.0), 0.0);
}

TEST_F(IndexAnalyses, BandIsThatOfTheFrameInAnySelection) {
  const Table all = fed<Band>(6).tables()[0].table;
  Band one(AnalysisInput{scene_, 1, 0.0});
  const Frame frame = syntheticFrame(scene_, 4);
  one.accept(frame);
  const MixingBand band =
      mixingBand(countCells(frame, samplingGrid(scene_)), 4, static_cast<std::uint64_t>(frame.step));
  ASSERT_TRUE(band.lacey.low);
  for (const std::string name : {"lacey", "lacey_low", "ashton_high"})
    EXPECT_EQ((*all.find(name))[4], (*one.tables()[0].table.find(name))[0]) << name;
  EXPECT_EQ((*all.find("lacey_low"))[4], band.lacey.low);
  EXPECT_EQ((*all.find("ashton_high"))[4], band.ashton.high);
}

TEST(SamplingSeries, GoesFromQuarterOfThePapersCellsToAFewDiameters) {
  const Scene scene;
  const auto series = samplingSeries(scene);
  EXPECT_EQ(series.front().columns, 2);
  EXPECT_EQ(series.front().rows, 4);
  bool own = false;
  for (const SamplingGrid& grid : series) {
    const double width = grid.width / grid.columns, height = grid.height / grid.rows;
    EXPECT_GE(std::min(width, height), 1.5 * scene.particles.diameter);
    EXPECT_GE(grid.minParticles, 1);
    if (grid.columns == 4 && grid.rows == 15) own = grid.minParticles == 21;  // as the paper has it
  }
  EXPECT_TRUE(own);
  EXPECT_GE(series.size(), 7u);
  EXPECT_LT(series.back().width / series.back().columns, 2.2 * scene.particles.diameter);
}

TEST_F(IndexAnalyses, SamplingIsTheMeanOfTheSecondHalfOnEachGrid) {
  const Table table = fed<SamplingSize>(5).tables()[0].table;
  const auto series = samplingSeries(scene_);
  ASSERT_EQ(table.rows(), series.size());
  ASSERT_GT(series.size(), 2u);
  for (std::size_t row = 0; row < series.size(); ++row) {
    double lacey = 0.0, neighbours = 0.0, cells = 0.0;
    for (int i = 2; i < 5; ++i) {
      const Frame frame = syntheticFrame(scene_, i);
      const MixingSample sample = mixingSample(frame, series[row]);
      lacey += sample.lacey.value_or(NAN) / 3;
      cells += sample.cells / 3.0;
      neighbours += *neighbourIndex(frame) / 3;
    }
    EXPECT_NEAR(*(*table.find("cells"))[row], cells, 1e-12);
    if (std::isfinite(lacey)) {
      EXPECT_NEAR(*(*table.find("lacey"))[row], lacey, 1e-12);
    }
    EXPECT_NEAR(*(*table.find("nearest_neighbour"))[row], neighbours, 1e-12);
  }
}

TEST_F(IndexAnalyses, AreToBeChosenByName) {
  const auto chosen = chooseAnalyses("indices,band,sampling", scene_);
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->size(), 3u);
}

}  // namespace
}  // namespace bedmix
