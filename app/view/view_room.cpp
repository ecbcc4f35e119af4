// SPDX-License-Identifier: MIT
#include "app/view/stream_message.h"
#include "app/view/view_connection.h"

#include <fmt/format.h>

#include <algorithm>

namespace bedmix {

bool ViewRoom::hasController() const {
  return std::any_of(members.begin(), members.end(),
                     [](const auto& member) { return member.second.role == Role::controller; });
}

ClientId ViewRoom::join(std::shared_ptr<ViewClient> client, Role mayBe) {
  const Role role = mayBe == Role::controller && !hasController() ? Role::controller : Role::viewer;
  const ClientId id = ++lastId;
  members.emplace(id, Member{std::move(client), mayBe, Role::viewer});
  host.joined(id, role);
  setRole(id, role);
  return id;
}

void ViewRoom::leave(ClientId client) {
  if (members.erase(client) == 0) return;
  host.left(client);
  if (hasController()) return;
  for (const auto& [id, member] : members)
    if (member.mayBe == Role::controller) {
      setRole(id, Role::controller);
      host.changed(id, Role::controller);
      return;
    }
}

void ViewRoom::requestControl(ClientId client) {
  const auto found = members.find(client);
  if (found == members.end() || found->second.mayBe != Role::controller) return;
  for (const auto& [id, member] : members)
    if (id != client && member.role == Role::controller) {
      setRole(id, Role::viewer);
      host.changed(id, Role::viewer);
    }
  setRole(client, Role::controller);
  host.changed(client, Role::controller);
}

/// The page learns whether it steers, and whether it could.
void ViewRoom::setRole(ClientId client, Role role) {
  Member& member = members.at(client);
  member.role = role;
  member.client->send(std::make_shared<const std::vector<std::byte>>(noticeMessage(
      fmt::format(R"({{"role": "{}", "mayControl": {}}})", role == Role::controller ? "controller" : "viewer",
                  member.mayBe == Role::controller))));
}

Role ViewRoom::roleOf(ClientId client) const {
  const auto found = members.find(client);
  return found == members.end() ? Role::viewer : found->second.role;
}

}  // namespace bedmix
