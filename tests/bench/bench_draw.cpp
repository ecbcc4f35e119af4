// SPDX-License-Identifier: MIT
// Pictures, sheets and films of beds made by hand; LP_NUM_THREADS sets the rasterizer's threads, 0 for none
// of its own.
//   bench_draw [--benchmark_filter=REGEX ...]
//   bench_draw --write FOLDER    the frames themselves, rows `x y vx vy species`, for another program to draw
#include "render/draw_bed.h"
#include "render/film_sink.h"
#include "render/hud.h"
#include "render/hud_rows.h"
#include "render/painter.h"
#include "render/png.h"
#include "render/sheet.h"
#include "tests/render/bed.h"

#include <fmt/os.h>

#include <benchmark/benchmark.h>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace bedmix::bench {

namespace {

constexpr Size small{1280, 720}, large{1920, 1080};

/// Benchmarks have nobody to hand a problem to.
template <class T>
T must(Result<T> result) {
  if (!result) throw std::runtime_error("bench: " + result.problems.front().message);
  return std::move(*result);
}

/// The paper's bed of a thousand, or one of 100,000 in the shape of a screen, which it fills.
Scene bedOf(std::int64_t particles) {
  if (particles == 1000) return test::flatBed();
  Scene scene = test::gaslessBed();
  scene.particles.count = particles;
  scene.bed.width = 1.9;
  scene.bed.height = 1.2;
  return scene;
}

/// Every frame differs from the one before, as a wave goes through the bed.
std::vector<Frame> framesOf(const Scene& scene, std::size_t count) {
  std::vector<Frame> frames;
  for (std::size_t k = 0; k < count; ++k) {
    frames.push_back(test::movingFrame(scene, 0.02 * static_cast<double>(k)));
    for (Vec2f& p : frames.back().position)
      p.y += 0.004f * (1.0f + std::sin(40.0f * p.x + 6.0f * static_cast<float>(frames.back().time)));
  }
  return frames;
}

void drawFrames(benchmark::State& state, const Scene& scene, Size size) {
  const std::vector<Frame> frames = framesOf(scene, 8);
  Painter painter = must(Painter::create(scene, {size, {}, 0}));
  Image image;
  std::size_t k = 0;
  for (auto _ : state) must(painter.paint(frames[k++ % frames.size()], image));
  state.SetItemsProcessed(state.iterations());
}

void drawing(benchmark::State& state) {
  drawFrames(state, bedOf(state.range(0)), state.range(0) == 1000 ? small : large);
}
BENCHMARK(drawing)->Arg(1000)->Arg(100000)->MeasureProcessCPUTime()->UseRealTime()->Unit(
    benchmark::kMillisecond);

/// A thousand discs as large as the picture has room for.
void drawingWide(benchmark::State& state) {
  Scene scene = test::gaslessBed();
  scene.bed.width = 0.24;
  scene.bed.height = 0.13;
  drawFrames(state, scene, small);
}
BENCHMARK(drawingWide)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

/// What of it is no OpenGL: the list of shapes and the mesh of the texts.
void listing(benchmark::State& state) {
  const Scene scene = bedOf(state.range(0));
  const std::vector<Frame> frames = framesOf(scene, 8);
  const Size size = state.range(0) == 1000 ? small : large;
  const Style style;
  const Layout layout = layoutPicture(scene, size, style);
  Hud hud(layout.em);
  DrawList bed, overlay;
  bed.clip = layout.view;
  std::size_t k = 0;
  for (auto _ : state) {
    bed.clear();
    overlay.clear();
    const Frame& frame = frames[k++ % frames.size()];
    drawBed(bed, scene, frame, layout.camera, style, layout.em);
    drawHud(overlay, scene, frame, style, layout);
    benchmark::DoNotOptimize(hud.mesh(size, overlay.texts));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(listing)->Arg(1000)->Arg(100000)->MeasureProcessCPUTime()->UseRealTime()->Unit(
    benchmark::kMillisecond);

/// A painter and its first picture.
void firstPicture(benchmark::State& state) {
  const Scene scene = bedOf(1000);
  const Frame frame = framesOf(scene, 1).front();
  Image image;
  for (auto _ : state) {
    Painter painter = must(Painter::create(scene, {small, {}, 0}));
    must(painter.paint(frame, image));
  }
}
BENCHMARK(firstPicture)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

/// Nine panels, drawn and written.
void sheet(benchmark::State& state) {
  const Scene scene = bedOf(1000);
  SheetRun run{&scene, {}, ""};
  for (Frame& frame : framesOf(scene, 9))
    run.frames.push_back(std::make_shared<const Frame>(std::move(frame)));
  const auto path = std::filesystem::temp_directory_path() / "bench_draw_sheet.png";
  for (auto _ : state)
    must(writePng(path, must(drawSheet({&run, 1})), {.small = true, .text = {}, .dpi = sheetDpi}));
  std::filesystem::remove(path);
}
BENCHMARK(sheet)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

/// Ten seconds of the paper's bed at 60 pictures a second.
void film(benchmark::State& state) {
  const Scene scene = bedOf(1000);
  const std::vector<Frame> frames = framesOf(scene, 501);
  const auto path = std::filesystem::temp_directory_path() / "bench_draw_film.mp4";
  for (auto _ : state) {
    FilmSink film = must(FilmSink::create(scene, path, {{small, {}, 0}, 60.0}));
    for (const Frame& frame : frames) film.accept(frame);
    must(film.finish());
    state.SetItemsProcessed(film.pictures());
  }
  std::filesystem::remove(path);
}
BENCHMARK(film)->MeasureProcessCPUTime()->UseRealTime()->Iterations(1)->Unit(benchmark::kSecond);

void writeFrames(const std::filesystem::path& folder) {
  for (const std::int64_t particles : {1000, 100000}) {
    const std::vector<Frame> frames = framesOf(bedOf(particles), 8);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const Frame& f = frames[k];
      auto file = fmt::output_file((folder / fmt::format("{}_{}.txt", particles, k)).string());
      for (std::size_t i = 0; i < f.size(); ++i)
        file.print("{} {} {} {} {}\n", f.position[i].x, f.position[i].y, f.velocity[i].x, f.velocity[i].y,
                   f.species[i]);
    }
  }
}

}  // namespace

}  // namespace bedmix::bench

int main(int argc, char** argv) {
  if (argc == 3 && std::string_view(argv[1]) == "--write") {
    bedmix::bench::writeFrames(argv[2]);
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
