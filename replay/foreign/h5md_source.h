// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_source.h"

namespace bedmix {

/// An H5MD 1.1 file (de Buyl et al. 2014, Comput. Phys. Commun. 185:1546) as MD and DEM codes write it. Of
/// each group of particles: `position` in two or three dimensions and, where they are there, `velocity`,
/// `angular_velocity` (about the third axis, or a vector), `radius` or `diameter`, `species` and `id`, each
/// fixed or changing with time; `box` with upright `edges`. A row whose id is below 0 is of no particle then:
/// so particles leave. HDF5 works in a process of the source's own, which reads ahead; damage on which it
/// fails is a Diagnostic like any other.
class H5mdSource final : public ForeignSource {
 public:
  /// The particles of a group; of all groups, in the order of their names, where that is empty. Then species
  /// are the groups' numbers unless all groups have species, and ids stay as they are unless two groups have
  /// the same or ids change with time: then they are id * groups + the group's number.
  static Result<std::unique_ptr<ForeignSource>> open(const std::filesystem::path& path,
                                                     const std::string& group);
  ~H5mdSource() override;

  int dimensions() const override;
  const std::vector<std::int64_t>& steps() const override;
  const std::vector<double>& times() const override;
  std::optional<ForeignBox> box() const override;
  Result<ForeignFrame> frame(std::size_t index) override;

 private:
  struct State;
  explicit H5mdSource(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace bedmix
