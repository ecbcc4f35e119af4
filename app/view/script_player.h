// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/view_script.h"
#include "app/view/view_session.h"

#include <deque>
#include <vector>

namespace bedmix {

/// Does what a script says, picture by picture.
class ScriptPlayer {
 public:
  explicit ScriptPlayer(const ViewScript& script) : script_(script) {}

  /// Whether the script has ended, and all is done that was to be done by then.
  bool atEnd() const;
  /// The next picture, the first at 0 s, into `image`. Fails where a step names something that the panel does
  /// not have.
  Result<Done> next(ViewSession& session, Image& image);

 private:
  using Events = std::vector<InputEvent>;

  Result<std::vector<Events>> eventsOf(const ScriptStep& step, const ViewSession& session);
  Result<Vec2f> placeOf(const ScriptPlace& place, float share, const ScriptStep& step,
                        const ViewSession& session) const;
  bool scrollTo(const ScriptStep& step, const ViewSession& session);

  const ViewScript& script_;
  std::int64_t pictures_ = 0;
  std::size_t nextStep_ = 0;
  int scrolls_ = 0;             // for the step in hand
  std::deque<Events> waiting_;  // of it, one of them a picture
};

}  // namespace bedmix
