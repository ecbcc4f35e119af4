// SPDX-License-Identifier: MIT
#include "engine/core/particle_list.h"
#include "engine/effects/feed_settings.h"

#include <fmt/format.h>

#include <utility>

namespace bedmix {

namespace {

class FeedRules {
 public:
  FeedRules(const Scene& scene, const FeedSettings& feed) : scene_(scene), feed_(feed) {}

  std::vector<Contradiction> broken() {
    if (feed_.streams.empty() && feed_.outlets.empty())
      add("feed", {},
          "[feed] has neither [[feed.streams]] nor [[feed.outlets]], so that nobody comes or goes; give one");
    if (feed_.most < scene_.particles.count)
      add("feed.most", {"particles.count"},
          fmt::format("the run begins with {} particles, more than the {} that there may be",
                      scene_.particles.count, feed_.most));
    for (std::size_t i = 0; i < feed_.streams.size(); ++i) stream(fmt::format("feed.streams.{}.", i), i);
    for (std::size_t i = 0; i < feed_.outlets.size(); ++i) outlet(fmt::format("feed.outlets.{}.", i), i);
    return std::move(broken_);
  }

 private:
  void add(std::string path, std::vector<std::string> concerns, std::string message) {
    broken_.push_back({std::move(path), std::move(message), std::move(concerns)});
  }

  void stream(const std::string& path, std::size_t index) {
    const FeedStream& s = feed_.streams[index];
    if (!kindNamed(scene_, s.species))
      add(path + "species", {"particles"},
          fmt::format("there is no kind of particles called \"{}\"", s.species));
    const double d = particleRange(scene_).largest;
    if (s.to - s.from < d)
      add(path + "to", {path + "from", "particles"},
          fmt::format("from {} to {} m there is no room for a particle, of {:.3g} m; make the line longer",
                      s.from, s.to, d));
    if (s.to > scene_.bed.width)
      add(path + "to", {"bed.width"},
          fmt::format("the line goes on to {} m, but the bed ends at {} m", s.to, scene_.bed.width));
    if (scene_.bed.top == BedTop::lid && s.y > scene_.bed.height)
      add(path + "y", {"bed.top", "bed.height"},
          fmt::format("particles cannot come in at {} m, above the lid at {} m", s.y, scene_.bed.height));
    if (s.temperature && !scene_.effects.find<HeatSettings>())
      add(path + "temperature", {"heat"},
          "what comes in has a temperature, and there is no [heat]; give it or leave temperature out");
    for (std::size_t o = 0; o < feed_.outlets.size(); ++o) {
      const FeedOutlet& box = feed_.outlets[o];
      if (s.y >= box.bottom && s.y <= box.top && s.from < box.to && s.to > box.from)
        add(path + "y", {fmt::format("feed.outlets.{}", o)},
            fmt::format("particles come in within outlet {}, which takes them out at once", o));
    }
  }

  void outlet(const std::string& path, std::size_t index) {
    const FeedOutlet& box = feed_.outlets[index];
    if (box.to <= box.from)
      add(path + "to", {path + "from"},
          fmt::format("the box goes from {} to {} m; its right side must be right of the left one", box.from,
                      box.to));
    if (box.top <= box.bottom)
      add(path + "top", {path + "bottom"},
          fmt::format("the box goes from {} up to {} m; its upper side must be above the lower one",
                      box.bottom, box.top));
  }

  const Scene& scene_;
  const FeedSettings& feed_;
  std::vector<Contradiction> broken_;
};

}  // namespace

std::vector<Contradiction> contradictions(const Scene& scene, const FeedSettings& feed) {
  return FeedRules(scene, feed).broken();
}

double feedRate(const Scene& scene) {
  const FeedSettings* feed = scene.effects.find<FeedSettings>();
  double rate = 0.0;
  if (feed)
    for (const FeedStream& stream : feed->streams) rate += stream.rate;
  return rate;
}

}  // namespace bedmix
