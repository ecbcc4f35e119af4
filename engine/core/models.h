// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace bedmix {

/// One selectable model: what a scene calls it, what it computes, where it comes from.
struct ModelInfo {
  std::string_view name;
  std::string_view formula;
  std::string_view citation;
};

/// How particles are advanced in time.
enum class Integrator { velocityVerlet, rk4, symplecticEuler, verletOnset };
/// Momentum exchange between gas and particles.
enum class DragLaw {
  ergunWenYu,
  ergunWenYuPrinted,
  ergun,
  wenYu,
  gidaspow,
  diFelice,
  kochHill,
  beetstra,
  syamlalOBrien
};
/// How pressure and velocity are brought together in one gas step.
enum class GasScheme { projection, simple };
/// Time level of convection and diffusion in the gas.
enum class TimeScheme { crankNicolson, implicitEuler };
/// What particles meet at the upper end of the bed.
enum class BedTop { open, lid };
/// What particles and gas meet at the left and right end of the bed.
enum class BedSides { walls, periodic };
/// How particles see an inclined distributor.
enum class FloorShape { straight, stair };
/// What stands in the bed.
enum class ObstacleShape { circle, drum, segment };
/// How a run begins.
enum class Arrangement { settled, drop };
/// Which particles carry the tracer colour.
enum class TracerRule { leftHalf, rightHalf, lowerHalf, upperHalf, species, fed };
/// How rolling is resisted.
enum class RollingModel { elasticPlastic, constantTorque };
/// How the diameters of one kind of particles differ.
enum class SizeDistribution { normal, lognormal, uniform };

/// How what enters by an inlet goes up and down.
enum class PulseShape { sine, square };

/// Force of the gas's shear on particles, and of their spin.
enum class ShearLift { mei, saffman, none };
enum class SpinLift { lunLiu, rubinowKeller, none };
/// What others around a particle do to its virtual mass.
enum class Crowding { zuber, none };
/// How a content of particles goes.
enum class ReactionModel { firstOrder, constantRate };

/// How much a run may err and cost; see presets.h for what each stands for.
enum class Accuracy { draft, standard, paper, reference };

/// The one visible table of each family, in the order of its enumeration; the first entry is the default.
template <class E>
inline constexpr std::array<ModelInfo, 0> modelTable{};

template <>
inline constexpr std::array modelTable<Integrator>{
    ModelInfo{"velocity-verlet", "x += v dt + a dt^2/2, v += (a_old + a_new) dt/2, forces at v + a dt",
              "Swope et al. (1982), J. Chem. Phys. 76:637"},
    ModelInfo{"rk4", "classical 4th-order Runge-Kutta, tangential springs as state",
              "Tian et al. (2007), Fuel Process. Technol. 88:187"},
    ModelInfo{"symplectic-euler", "v += a dt, x += v dt",
              "Hairer, Lubich & Wanner (2003), Acta Numer. 12:399"},
    ModelInfo{"verlet-onset",
              "velocity-verlet with the mean contact force over [t - dt/2, t + dt/2] along the overlap's "
              "tangent: contacts begin and end within a step",
              "this program, assets/docs/model.md"},
};
template <>
inline constexpr std::array modelTable<DragLaw>{
    ModelInfo{"ergun-wen-yu",
              "eps <= 0.8: 150 (1-eps)^2 mu/(eps d^2) + 1.75 (1-eps) rho |u-v|/d; above: "
              "3/4 C_D eps (1-eps) rho |u-v|/d eps^-2.65",
              "Tian et al. (2007), Eqs (3a), (3b), (4), read consistently with Eqs (2) and (9)"},
    ModelInfo{"ergun-wen-yu-printed",
              "as ergun-wen-yu, but 3/4 C_D (1-eps) rho |u-v|/d eps^-2.65 above eps 0.8",
              "Tian et al. (2007), Eq. (3b) without the factor eps"},
    ModelInfo{"ergun", "150 (1-eps)^2 mu/(eps d^2) + 1.75 (1-eps) rho |u-v|/d at any eps",
              "Ergun (1952), Chem. Eng. Prog. 48:89"},
    ModelInfo{"wen-yu", "3/4 C_D eps (1-eps) rho |u-v|/d eps^-2.65 at any eps",
              "Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62:100"},
    ModelInfo{
        "gidaspow",
        "(1-phi) of ergun and phi of wen-yu, phi = arctan(262.5 (eps-0.8))/pi + 1/2; C_D = 0.44 from Re "
        "1000 on",
        "Gidaspow (1994), Multiphase Flow and Fluidization; Huilin & Gidaspow (2003), Chem. Eng. Sci. "
        "58:3777"},
    ModelInfo{
        "di-felice",
        "3/4 C_D eps^2 (1-eps) rho |u-v|/d eps^-chi, chi = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2/2), C_D = "
        "(0.63 + 4.8/sqrt(Re))^2",
        "Di Felice (1994), Int. J. Multiphase Flow 20:153"},
    ModelInfo{"koch-hill", "18 (1-eps) eps^2 mu/d^2 (F0(eps) + F3(eps) Re/2)",
              "Hill, Koch & Ladd (2001), J. Fluid Mech. 448:243; Koch & Hill (2001), Annu. Rev. Fluid Mech. "
              "33:619"},
    ModelInfo{"beetstra",
              "18 (1-eps) eps mu/d^2 F(eps, Re), fitted to lattice Boltzmann simulations of random arrays up "
              "to Re 1000",
              "Beetstra, van der Hoef & Kuipers (2007), AIChE J. 53:489"},
    ModelInfo{
        "syamlal-obrien",
        "3/4 C_D eps (1-eps) rho |u-v|/(V^2 d), C_D = (0.63 + 4.8 sqrt(V/Re))^2, Re = rho d |u-v|/mu, V "
        "the relative settling velocity; constants 0.8, 2.65",
        "Syamlal & O'Brien (1987), METC report; Syamlal, Rogers & O'Brien (1993), MFIX Documentation: "
        "Theory Guide, DOE/METC-94/1004"},
};
template <>
inline constexpr std::array modelTable<GasScheme>{
    ModelInfo{"projection", "one implicit momentum predictor, then pressure corrections (PISO)",
              "Issa (1986), J. Comput. Phys. 62:40"},
    ModelInfo{"simple", "predictor and under-relaxed pressure correction repeated until both residuals fall",
              "Patankar (1980), Numerical Heat Transfer and Fluid Flow; used by Tian et al. (2007)"},
};
template <>
inline constexpr std::array modelTable<TimeScheme>{
    ModelInfo{"crank-nicolson", "convection and diffusion half at the old, half at the new time level",
              "Tian et al. (2007)"},
    ModelInfo{"implicit-euler", "convection and diffusion at the new time level", "backward Euler"},
};
template <>
inline constexpr std::array modelTable<BedTop>{
    ModelInfo{"open", "particles may rise above the gas grid and fall back; coupling tapers to zero there",
              ""},
    ModelInfo{"lid", "a wall for particles at the bed's height that lets the gas through", ""},
};
template <>
inline constexpr std::array modelTable<BedSides>{
    ModelInfo{"walls", "side walls, at which the gas does not slip", ""},
    ModelInfo{"periodic", "none: what leaves the bed at one side comes in at the other",
              "minimum image: Allen & Tildesley (1987), Computer Simulation of Liquids, section 1.5.2"},
};
template <>
inline constexpr std::array modelTable<FloorShape>{
    ModelInfo{"straight", "particles meet one straight incline", ""},
    ModelInfo{"stair", "particles meet the stair of blocked gas cells", ""},
};
template <>
inline constexpr std::array modelTable<ObstacleShape>{
    ModelInfo{"circle", "a round tube seen from its end: particles are around it", ""},
    ModelInfo{"drum", "a circle that particles are inside of", ""},
    ModelInfo{"segment", "a straight plate seen from its edge, touched from both sides", ""},
};
template <>
inline constexpr std::array modelTable<Arrangement>{
    ModelInfo{"settled", "dropped at random without gas and brought to rest before t = 0", ""},
    ModelInfo{"drop", "random positions without overlap, falling from t = 0 on", ""},
};
template <>
inline constexpr std::array modelTable<TracerRule>{
    ModelInfo{"left-half", "x < width/2 at the start", "Tian et al. (2007)"},
    ModelInfo{"right-half", "x >= width/2 at the start", ""},
    ModelInfo{"lower-half", "the half of the particles that lies lowest at the start", ""},
    ModelInfo{"upper-half", "the half of the particles that lies highest at the start", ""},
    ModelInfo{"species", "all but the first kind of particles", ""},
    ModelInfo{"fed", "those that come in by [feed]", ""},
};
template <>
inline constexpr std::array modelTable<RollingModel>{
    ModelInfo{"elastic-plastic", "spring 2.25 k (mu_r R)^2 and dashpot, at most mu_r R F_n (type C)",
              "Ai, Chen, Rotter & Ooi (2011), Powder Technol. 206:269"},
    ModelInfo{"constant-torque", "mu_r R F_n against the relative spin (type A)",
              "Ai, Chen, Rotter & Ooi (2011), Powder Technol. 206:269"},
};
template <>
inline constexpr std::array modelTable<ReactionModel>{
    ModelInfo{"first-order", "dX/dt = -k X", ""},
    ModelInfo{"constant-rate", "dX/dt = -k until none is left, as a wet surface dries", ""},
};
template <>
inline constexpr std::array modelTable<SizeDistribution>{
    ModelInfo{"normal", "d = mean (1 + deviation z), |z| <= cut", ""},
    ModelInfo{"lognormal", "d = median exp(deviation z), |z| <= cut", ""},
    ModelInfo{"uniform", "all between mean (1 - sqrt(3) deviation) and mean (1 + sqrt(3) deviation)", ""},
};
template <>
inline constexpr std::array modelTable<PulseShape>{
    ModelInfo{"sine", "1 + amplitude sin(2 pi (frequency t + phase))", ""},
    ModelInfo{
        "square",
        "1 - amplitude, and for the first duty of each period 1 + amplitude (1 - duty)/duty: the mean is 1",
        ""},
};
template <>
inline constexpr std::array modelTable<ShearLift>{
    ModelInfo{"mei",
              "1.615 d^2 sqrt(rho mu/|o|) f (w x o), w = u-v, o = rot u, b = d |o|/(2 |w|); f = (1 - 0.3314 "
              "sqrt(b)) exp(-Re/10) + 0.3314 sqrt(b), above Re 40 0.0524 sqrt(b Re)",
              "Mei (1992), Int. J. Multiphase Flow 18:145"},
    ModelInfo{"saffman", "the same with f = 1",
              "Saffman (1965), J. Fluid Mech. 22:385, corrected (1968) 31:624"},
    ModelInfo{"none", "no force", ""},
};
template <>
inline constexpr std::array modelTable<SpinLift>{
    ModelInfo{
        "lun-liu",
        "-pi/8 d^3 rho g (s x w), s = spin - o/2, g = 1, above Re 1 0.178 + 0.822 Re^-0.522; torque -pi "
        "mu d^3 h s, h = 1, above Re_s = rho d^2 |s|/mu = 32 (12.9 sqrt(Re_s) + 128.4)/(64 pi)",
        "Lun & Liu (1997), Int. J. Multiphase Flow 23:575; Dennis, Singh & Ingham (1980), J. Fluid Mech. "
        "101:257"},
    ModelInfo{"rubinow-keller", "the same with g = h = 1", "Rubinow & Keller (1961), J. Fluid Mech. 11:447"},
    ModelInfo{"none", "neither force nor torque", ""},
};
template <>
inline constexpr std::array modelTable<Crowding>{
    ModelInfo{"zuber", "C (3 - 2 eps)/eps", "Zuber (1964), Chem. Eng. Sci. 19:897"},
    ModelInfo{"none", "C everywhere", "Auton, Hunt & Prud'homme (1988), J. Fluid Mech. 197:241"},
};
template <>
inline constexpr std::array modelTable<Accuracy>{
    ModelInfo{"draft", "the longest steps that hold: for a first look", ""},
    ModelInfo{"standard", "steps chosen by error targets, below what seeds differ by", ""},
    ModelInfo{"paper", "the numerics of the paper: rk4, 1e-5 s, SIMPLE every 1e-4 s",
              "Tian et al. (2007), Fuel Process. Technol. 88:187"},
    ModelInfo{"reference", "steps chosen by error targets that leave no trace of them", ""},
};

template <class E>
constexpr std::string_view modelName(E e) {
  return modelTable<E>[static_cast<std::size_t>(e)].name;
}
template <class E>
constexpr std::optional<E> findModel(std::string_view name) {
  for (std::size_t i = 0; i < modelTable<E>.size(); ++i)
    if (modelTable<E>[i].name == name) return static_cast<E>(i);
  return std::nullopt;
}

}  // namespace bedmix
