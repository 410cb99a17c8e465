// The spectrum of what the live plots show: of any channel of the board, computed beside the window's thread.
#pragma once

#include <QThreadPool>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "session/visible_spectrum.h"
#include "widgets/live_channels.h"

class QCPGraph;
class QCPItemStraightLine;
class QCustomPlot;
class QComboBox;

namespace breakaway {

class ElidedLabel;

class LiveSpectrum : public QWidget {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  explicit LiveSpectrum(const LiveHistory& history, QWidget* parent = nullptr);
  ~LiveSpectrum() override;

  /// What is chosen and what is read off, for a row above; shown and hidden with the picture.
  QWidget* controls() const { return controls_; }
  void nameChannels(bool linear);
  /// The stretch that is visible; computed anew unless the last one still is.
  void show(double from_s, double to_s);
  /// The highest line within what the axis of frequency shows.
  std::optional<SpectrumPeak> peak() const;
  QString reading() const;

  /// The frequencies that somebody chose.
  QVariant kept() const;
  void take(const QVariant& kept);

 private:
  void buildControls();
  void buildPlot();
  void applyLook();
  void choose();
  void compute();
  void take(std::shared_ptr<const VisibleSpectrum> spectrum);
  void showAll();
  void draw();
  void read();
  const LiveChannel& channel() const;

  const LiveHistory& history_;
  QWidget* controls_ = nullptr;
  QComboBox* channelBox_ = nullptr;
  QComboBox* windowBox_ = nullptr;
  ElidedLabel* reading_ = nullptr;
  QCustomPlot* plot_ = nullptr;
  QCPGraph* graph_ = nullptr;
  QCPItemStraightLine* mark_ = nullptr;
  std::vector<LiveChannel> channels_;
  std::shared_ptr<const VisibleSpectrum> spectrum_;
  double from_s_ = 0.0, to_s_ = 0.0;
  bool linear_ = false;
  bool zoomed_ = false;  ///< by hand: the axis of frequency stays
  bool drawing_ = false;
  bool running_ = false, again_ = false;
  QTimer next_;
  unsigned wanted_ = 0;  ///< number of the newest choice
  QThreadPool pool_;
};

}  // namespace breakaway
