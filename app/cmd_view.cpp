// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/gl_option.h"
#include "app/interrupt.h"
#include "app/picture_options.h"
#include "app/recorded_runs.h"
#include "app/run_folder.h"
#include "app/scene_library.h"
#include "app/view/live_model.h"
#include "app/view/picture_stream.h"
#include "app/view/recorded_model.h"
#include "app/view/script_player.h"
#include "app/view/view_server.h"
#include "engine/core/particle_list.h"
#include "engine/core/presets.h"
#include "engine/core/thread_team.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <thread>

namespace bedmix {

namespace {

struct ViewOptions {
  std::vector<std::string> what;  // a scene, or one run or two
  std::vector<std::string> settings;
  std::string accuracy;
  PictureOptions pictures;
  RecordingOptions recordings;
  ListenOptions listen;
  std::string folder;
  std::string script, frames;
};

/// Whether a name is that of a scene and not of something recorded.
bool isScene(const std::string& name) {
  const std::filesystem::path path(name);
  std::error_code error;
  return path.extension() == ".toml" || !std::filesystem::exists(path, error);
}

/// What is looked at, opened as far as it can be before there is a picture.
struct Subject {
  std::optional<Scene> scene;  // a live run's
  std::vector<RecordedRun> runs;
  std::string name;
  Style style;

  bool isLive() const { return scene.has_value(); }
};

Result<Subject> openSubject(const ViewOptions& options) {
  Subject subject;
  if (options.what.size() == 1 && isScene(options.what.front())) {
    std::vector<Override> overrides;
    if (!options.accuracy.empty()) overrides = accuracyOverrides(options.accuracy);
    auto settings = settingOverrides(options.settings);
    if (!settings) return settings.problems;
    overrides.insert(overrides.end(), settings->begin(), settings->end());
    auto scene = loadScene(options.what.front(), overrides);
    if (!scene) return scene.problems;
    subject.name = scene->name;
    subject.scene = std::move(*scene);
  } else {
    auto runs = openRuns(options.what, options.recordings);
    if (!runs) return runs.problems;
    subject.runs = std::move(*runs);
    subject.name = subject.runs.front().name;
  }
  const auto paint =
      paintOptions(options.pictures, subject.isLive() ? *subject.scene : subject.runs.front().scene());
  if (!paint) return paint.problems;
  subject.style = paint->style;
  return subject;
}

Result<ViewSession> makeSession(Subject& subject, const ViewOptions& options, Pace pace,
                                SessionOptions session) {
  session.style = subject.style;
  session.folder = options.folder.empty() ? "out/view-" + subject.name : options.folder;
  std::unique_ptr<ViewModel> model;
  if (subject.isLive()) {
    // The picture has a core of its own.
    const int threads = threadsFor(mostParticles(*subject.scene), std::max(1, availableCores() - 1));
    model = std::make_unique<LiveModel>(*subject.scene, threads, pace, session.folder);
  } else {
    model = std::make_unique<RecordedModel>(std::move(subject.runs), options.what, options.recordings, pace);
  }
  return ViewSession::create(std::move(model), session);
}

ExitCode playScript(Subject subject, const ViewOptions& options, const Console& console) {
  const auto script = readViewScript(options.script);
  if (!script) return console.fail(script.problems);
  const auto folder = makeFolder(options.frames);
  if (!folder) return console.fail(folder.problems);
  auto session = makeSession(subject, options, Pace::ticked,
                             {.size = script->size, .scale = script->scale, .style = {}, .folder = {}});
  if (!session) return console.fail(session.problems);
  ScriptPlayer player(*script);
  Image image;
  int pictures = 0;
  for (; !player.atEnd(); ++pictures) {
    if (stopRequested()) return ExitCode::stopped;
    if (const auto drawn = player.next(*session, image); !drawn) return console.fail(drawn.problems);
    const auto path = folder->path / fmt::format("frame_{:06}.png", pictures);
    if (const auto written = writePng(path, image); !written) return console.fail(written.problems);
  }
  for (const SavedFile& file : session->takeSaved()) console.say("saved " + file.path.string());
  console.say(fmt::format("{}: {} pictures", options.frames, pictures));
  return ExitCode::done;
}

/// The server as the stream sees it.
class ServerOutput final : public StreamOutput {
 public:
  explicit ServerOutput(std::unique_ptr<ViewServer>& server) : server_(server) {}
  void send(ClientId client, SharedBytes message) override { server_->send(client, std::move(message)); }
  void publish(const std::string& name, const std::string& type, SharedBytes content) override {
    server_->publish(name, type, std::move(content));
  }

 private:
  std::unique_ptr<ViewServer>& server_;
};

ExitCode serve(Subject subject, const ViewOptions& options, const Console& console) {
  PictureStream stream;
  auto server = ViewServer::create(options.listen, stream);
  if (!server) return console.fail(server.problems);
  ServerOutput output(*server);
  const auto begun = stream.begin([&] { return makeSession(subject, options, Pace::free, {}); }, output);
  if (!begun) return console.fail(begun.problems);
  if (options.listen.isPublic)
    console.warn(
        "everybody who can reach this machine and knows the address below controls the run; nothing is "
        "encrypted");
  console.print((*server)->controlUrl());
  console.say("to look on only: " + (*server)->viewUrl());
  console.say("on another machine: ssh -L PORT:127.0.0.1:PORT and the same address; Ctrl+C ends");
  while (!stopRequested()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  if (const std::string farewell = stream.end(); !farewell.empty()) console.say(farewell);
  server->reset();
  return ExitCode::stopped;
}

ExitCode view(const ViewOptions& options, const Console& console) {
  if (options.script.empty() != options.frames.empty())
    return console.fail("--script", "goes with --frames, the folder that its pictures go to");
  auto subject = openSubject(options);
  if (!subject) return console.fail(subject.problems);
  catchInterrupts();
  return options.script.empty() ? serve(std::move(*subject), options, console)
                                : playScript(std::move(*subject), options, console);
}

}  // namespace

void addViewCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand(
      "view", "Watch and steer a scene, or look through a recorded run, in a browser: no display is needed");
  auto options = std::make_shared<ViewOptions>();
  command->add_option("scene", options->what, "Scene, or recorded run; two runs are shown side by side")
      ->required()
      ->expected(1, 2)
      ->type_name("SCENE|RUN");
  command->add_option("--listen", options->listen.address, "Where to listen; port 0 takes a free one")
      ->type_name("ADDRESS:PORT")
      ->capture_default_str();
  command->add_flag("--public", options->listen.isPublic,
                    "Allow an address that other machines reach; nothing is encrypted, so better use ssh -L");
  command
      ->add_option("-o,--output", options->folder,
                   "Folder of what is saved and recorded; out/view-<scene> by default")
      ->type_name("DIR");
  command->add_option("--accuracy", options->accuracy, "Preset of a scene's numerics")->type_name("NAME");
  command->add_option("--set", options->settings, "Change a key of the scene, see bedmix run --help")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  addStyleOptions(*command, options->pictures);
  addRecordingOptions(*command, options->recordings);
  addGlOption(*command);
  command->add_option("--script", options->script, "Do what this file says, without a browser and the clock")
      ->type_name("FILE");
  command->add_option("--frames", options->frames, "Folder of the pictures of a script")->type_name("DIR");
  command->footer(
      "Examples:\n  bedmix view tian-2007-even\n  bedmix view out/even out/inclined --layers "
      "particles,walls,sampling,hud\n"
      "  bedmix view tian-2007-even --script tour.toml --frames out/tour");
  command->callback([options, context] { context.outcome = view(*options, context.console); });
}

}  // namespace bedmix
