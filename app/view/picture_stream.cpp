// SPDX-License-Identifier: MIT
#include "app/view/picture_stream.h"

#include "app/view/stream_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <fstream>
#include <future>
#include <iterator>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

namespace bedmix {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds interval{1.0 / streamRate};
constexpr Seconds inputInterval{1.0 / 60.0};  // between pictures that answer input
constexpr Seconds rest{0.25};                 // without news, until a sharp picture is sent
constexpr std::size_t mostEvents = 4096;      // that wait; more are dropped

Clock::time_point after(Clock::time_point start, Seconds seconds) {
  return start + std::chrono::duration_cast<Clock::duration>(seconds);
}

std::vector<std::byte> contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
  return {bytes, bytes + text.size()};
}

}  // namespace

struct PictureStream::State {
  using Order = std::function<void()>;

  std::mutex mutex;
  std::condition_variable_any changed;
  std::vector<Order> orders;  // of the server, for the stream's thread

  // Of the stream's thread alone.
  StreamOutput* output = nullptr;
  std::map<ClientId, StreamClient> clients;
  std::vector<InputEvent> events;
  std::uint32_t lastInput = 0;
  StreamPicture picture;
  Clock::time_point lastDraw = Clock::now(), lastNews = lastDraw;
  std::string cursor;
  bool keyboard = false;
  std::string farewell;
  std::jthread thread;  // last: joins before the rest goes

  bool someoneIsReady() const {
    return std::any_of(clients.begin(), clients.end(), [](const auto& c) { return c.second.isReady(); });
  }
  bool someoneWants(bool sharp) const {
    return std::any_of(clients.begin(), clients.end(), [&](const auto& c) {
      return sharp ? c.second.wantsSharp(picture) : c.second.wants(picture);
    });
  }
  void tellController(const std::string& json) {
    for (const auto& [id, client] : clients)
      if (client.role() == Role::controller)
        output->send(id, std::make_shared<const std::vector<std::byte>>(noticeMessage(json)));
  }

  void post(Order order) {
    const std::lock_guard lock(mutex);
    orders.push_back(std::move(order));
    changed.notify_all();
  }
  /// Each page counts its inputs for itself, and has heard of nothing yet.
  void startCounting() {
    lastInput = 0;
    cursor.clear();
    keyboard = false;
  }
  Clock::time_point nextTask() const;
  void wait(const std::stop_token& stop);
  void take(ClientId client, const ClientMessage& message);
  void draw(ViewSession& session);
  void tellWhatElse(ViewSession& session);
  void sendPictures(bool sharp, JpegEncoder& jpeg);
  void run(ViewSession& session, JpegEncoder& jpeg, const std::stop_token& stop);
};

/// When there is something to draw or to send.
Clock::time_point PictureStream::State::nextTask() const {
  if (someoneWants(false)) return lastDraw;
  Clock::time_point due = Clock::time_point::max();
  if (someoneIsReady()) due = after(lastDraw, events.empty() ? interval : inputInterval);
  if (someoneWants(true)) due = std::min(due, after(lastNews, rest));
  return due;
}

/// Until then, carrying out orders.
void PictureStream::State::wait(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::unique_lock lock(mutex);
    const Clock::time_point due = nextTask();
    const auto woken = [&] { return !orders.empty(); };
    if (due == Clock::time_point::max())
      changed.wait(lock, stop, woken);
    else
      changed.wait_until(lock, stop, due, woken);
    const std::vector<Order> taken = std::exchange(orders, {});
    lock.unlock();
    for (const Order& order : taken) order();
    if (nextTask() <= Clock::now()) return;
  }
}

void PictureStream::State::take(ClientId client, const ClientMessage& message) {
  const auto found = clients.find(client);
  if (found == clients.end()) return;
  if (const auto* hello = std::get_if<Hello>(&message)) found->second.greet(hello->codec);
  if (const auto* shown = std::get_if<Acknowledgement>(&message)) found->second.acknowledge(shown->picture);
  if (const auto* input = std::get_if<NumberedInput>(&message); input && events.size() < mostEvents) {
    events.push_back(input->event);
    lastInput = input->number;
  }
}

void PictureStream::State::draw(ViewSession& session) {
  const Clock::time_point now = Clock::now();
  const double seconds = Seconds(now - lastDraw).count();
  lastDraw = now;
  if (!session.draw(std::exchange(events, {}), seconds, picture.image)) return;
  ++picture.version;
  picture.input = lastInput;
  picture.quickJpeg = picture.sharpJpeg = nullptr;
  lastNews = now;
}

void PictureStream::State::tellWhatElse(ViewSession& session) {
  if (session.cursor() != cursor) {
    cursor = session.cursor();
    tellController(fmt::format(R"({{"cursor": "{}"}})", cursor));
  }
  if (session.wantsKeyboard() != keyboard) {
    keyboard = session.wantsKeyboard();
    tellController(fmt::format(R"({{"keyboard": {}}})", keyboard));
  }
  for (const SavedFile& file : session.takeSaved()) {
    const bool isPicture = file.path.extension() == ".png";
    output->publish(file.name, isPicture ? "image/png" : "application/toml",
                    std::make_shared<const std::vector<std::byte>>(contentOf(file.path)));
    tellController(fmt::format(R"({{"saved": "/saved/{}"}})", file.name));
  }
}

void PictureStream::State::sendPictures(bool sharp, JpegEncoder& jpeg) {
  for (auto& [id, client] : clients) {
    if (!(sharp ? client.wantsSharp(picture) : client.wants(picture))) continue;
    if (auto message = client.encode(picture, sharp, jpeg)) output->send(id, std::move(*message));
  }
}

void PictureStream::State::run(ViewSession& session, JpegEncoder& jpeg, const std::stop_token& stop) {
  for (wait(stop); !stop.stop_requested(); wait(stop)) {
    if (someoneIsReady() && Clock::now() >= after(lastDraw, events.empty() ? interval : inputInterval)) {
      draw(session);
      tellWhatElse(session);
    }
    sendPictures(false, jpeg);
    if (Clock::now() >= after(lastNews, rest)) sendPictures(true, jpeg);
  }
}

PictureStream::PictureStream() : state_(std::make_unique<State>()) {}
PictureStream::~PictureStream() { end(); }

Result<Done> PictureStream::begin(const MakeSession& make, StreamOutput& output) {
  State& s = *state_;
  s.output = &output;
  std::promise<Result<Done>> begun;
  auto outcome = begun.get_future();
  s.thread = std::jthread([&s, &make, &begun](const std::stop_token& stop) {
    auto session = make();
    auto jpeg = JpegEncoder::create();
    if (!session || !jpeg) return begun.set_value(session ? jpeg.problems : session.problems);
    begun.set_value(Done{});
    s.run(*session, *jpeg, stop);
    s.farewell = session->model().farewell();
  });
  return outcome.get();
}

std::string PictureStream::end() {
  state_->thread = {};
  return state_->farewell;
}

void PictureStream::joined(ClientId client, Role role) {
  state_->post([s = state_.get(), client, role] {
    s->clients.emplace(client, StreamClient(role));
    if (role == Role::controller) s->startCounting();
  });
}

void PictureStream::changed(ClientId client, Role role) {
  state_->post([s = state_.get(), client, role] {
    if (const auto found = s->clients.find(client); found != s->clients.end()) found->second.setRole(role);
    if (role == Role::controller) s->startCounting();
  });
}

void PictureStream::left(ClientId client) {
  state_->post([s = state_.get(), client] {
    const auto found = s->clients.find(client);
    if (found == s->clients.end()) return;
    if (found->second.role() == Role::controller) s->events.push_back({.kind = InputEvent::Kind::leave});
    s->clients.erase(found);
  });
}

void PictureStream::received(ClientId client, const ClientMessage& message) {
  state_->post([s = state_.get(), client, message] { s->take(client, message); });
}

}  // namespace bedmix
