// A rig as a linear regression along its recorded motion: integrated twice, so that nothing is differentiated.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "diagnose/fit/torque_noise.h"
#include "diagnose/fit/window.h"
#include "diagnose/model/effect.h"
#include "diagnose/model/model.h"
#include "diagnose/screen/effect_traces.h"
#include "diagnose/simulate/stepper.h"

namespace breakaway {

inline constexpr size_t everyTrack = static_cast<size_t>(-1);

/// One per track; rigs of one base model can share them.
using RecordedMotions = std::shared_ptr<const std::vector<RecordedMotion>>;
RecordedMotions recordedMotions(const Model& base, const std::vector<Track>& tracks);

/// Whether the torque is only what the model has, or noisy as well.
enum class Torque { steady, wandering };

/// The torque balance J a = drive − B ω − F s − Σ a_j c_j, integrated twice along each stretch of motion one way:
///   ∬drive = J x + B ∫x + F ∬s + Σ a_j ∬c_j + α + β t
/// with α and β free in each stretch. What an encoder adds to x stays what it is: white, and as large as one reading's
/// noise. Where the torque is noisy, too, the motion x is what has to be explained,
///   −J₀ x = J₀/J (−∬drive + B ∫x + F ∬s + Σ a_j ∬c_j + α + β t),  J₀ near J,
/// and rows are made independent: otherwise effects that depend on the drive explain a torque's noise by itself.
/// Directions are the recorded ones, so that stick-slip
/// can't run away, and where rows of current exist beside the voltage that drives, drive = Kt i and the voltage balance
/// is a second set of rows,
///   i = lag(u)/R − lag(ω) Ke/R − Σ a_j lag(c_j)/R,   lag the first-order lag L/R.
/// A third set of rows are the breakaways: at the end of each standstill the drive overcomes load and dry friction,
///   drive = F s + Σ a_j c_j,  known as well as the drive changes within the time that motion takes to show.
/// The method of integrals instead of derivatives follows M. Shinbrot's method functions ('On the analysis of linear
/// and nonlinear systems', Trans. ASME 79, 1957). Rows are means over some samples, weighted by their number, each set
/// in units of a typical residual.
class LinearRig {
 public:
  /// `base` gives gains, lag and the start values of J and F; tracks carry their smoothed motion.
  /// Where the torque wanders, rows are single readings, independent for the likeliest noise.
  LinearRig(const Model& base, const std::vector<Track>& tracks, const std::vector<Window>& windows,
            Torque torque = Torque::steady, RecordedMotions recorded = nullptr);

  const Eigen::VectorXd& response() const { return response_; }
  /// Columns of the base model.
  const Eigen::MatrixXd& base() const { return base_; }
  /// J, B, F … from the coefficients of the base's columns.
  Eigen::VectorXd physical(Eigen::VectorXd coefficients) const;
  /// Per amplitude the column of an effect at one shape; zero columns where the motion doesn't show it. `only` is the
  /// one track that it happens in.
  Eigen::MatrixXd columnsOf(const Effect& effect, const Shape& shape, size_t only = everyTrack) const;
  /// The same before rows are weighed, which takes less time for all columns at once.
  Eigen::MatrixXd rawColumnsOf(const Effect& effect, const Shape& shape, size_t only = everyTrack) const;
  void weigh(Eigen::Ref<Eigen::MatrixXd> columns) const;
  /// Of the torque, as the base model leaves it.
  const TorqueNoise& noise() const { return noise_; }
  /// Where the torque wanders: its likeliest noise beside the base and `more`, raw columns of effects.
  TorqueNoise wander(const Eigen::MatrixXd& more) const;
  TorqueNoise wander() const { return wander(Eigen::MatrixXd(rows_, 0)); }  ///< beside the base alone
  /// The tracks that the windows lie in.
  std::vector<size_t> tracksSeen() const;
  /// The window, by its number in the constructor's list, that a row belongs to.
  const std::vector<size_t>& window() const { return window_; }
  size_t windows() const { return windows_; }
  /// Readings behind the rows.
  double samples() const { return samples_; }

 private:
  /// Rows [first, last] of a track, moving one way.
  struct Stretch {
    size_t track = 0, first = 0, last = 0, window = 0;
    size_t samplesPerRow = 1, samplesTaken = 1;
    Eigen::Index at = 0, rows = 0;  ///< in the regression
    Eigen::VectorXd times = {};     ///< of the rows, s; of mechanical ones only
    Eigen::VectorXd impulses = {};  ///< as whiten() takes them
  };
  /// The end of a standstill: the last row at rest.
  struct Start {
    size_t track = 0, row = 0, window = 0;
    double direction = 0.0, drive = 0.0;
    Eigen::Index at = 0;
  };
  void findStarts(const std::vector<Window>& windows);
  /// Adds to `out` the values that act at each breakaway.
  void addStarts(const std::vector<double>& values, size_t track, double factor, Eigen::Ref<Eigen::VectorXd> out) const;
  double startDoubt(const Start& one) const;  ///< Nm
  Eigen::Index mechanicalRows() const;        ///< they come first
  /// What a slightly larger inductance would change, per relative change of it.
  Eigen::VectorXd byInductance() const;
  void freeInductance();
  void cut(const std::vector<Window>& windows);
  std::vector<RecordedStart> startsOf(size_t track) const;
  /// The first-order lag L/R of values that each act for one row: at the row's instant, or its mean over the row.
  std::vector<double> lagged(size_t track, const std::vector<double>& values, bool mean) const;
  std::vector<double> lagged(size_t track, const std::vector<double>& values, bool mean, double inductance) const;
  /// Mechanical rows of twice (`times` = 2), once or not at all integrated values; adds to `out`.
  void addMechanical(const std::vector<double>& values, size_t track, int times, double factor,
                     Eigen::Ref<Eigen::VectorXd> out) const;
  void addElectrical(const std::vector<double>& values, size_t track, double factor,
                     Eigen::Ref<Eigen::VectorXd> out) const;
  /// What wanders most likely beside the columns, of which the last is the response; rows beyond the first `rows` are
  /// known beforehand, in units of a reading's noise.
  TorqueNoise likeliest(const Eigen::MatrixXd& all, Eigen::Index rows) const;
  Eigen::VectorXd driveShift() const;
  double knownTo(double doubt) const;
  double longestRow_s() const;
  /// When each row was, s: the mean of its samples.
  Eigen::VectorXd timesOf(const Stretch& one) const;
  /// What the drive may have done that isn't known, as whiten() takes it: in missing rows and, where the torque is
  /// noisy, by its sensor.
  Eigen::VectorXd impulsesOf(const Stretch& one) const;
  /// Makes rows independent and takes out α and β.
  double whitenStretch(const TorqueNoise& noise, const Stretch& one, Eigen::Ref<Eigen::MatrixXd> rows) const;

  const std::vector<Track>& tracks_;
  Physics physics_;
  bool currentSeen_ = false;
  double gain_ = 1.0;  ///< Nm per unit of input
  Torque torque_;
  TorqueNoise noise_;
  RecordedMotions motions_;
  const std::vector<RecordedMotion>& recorded_;
  std::vector<Stretch> stretches_, electrical_;
  std::vector<Start> starts_;
  Eigen::Index rows_ = 0;
  std::vector<size_t> window_;
  size_t windows_ = 0;
  double samples_ = 0.0;
  Eigen::MatrixXd raw_;  ///< base and response, unweighed
  Eigen::VectorXd weights_;
  Eigen::VectorXd response_;
  Eigen::MatrixXd base_;
};

}  // namespace breakaway
