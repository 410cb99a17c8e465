// Maps of the project that are looked at: one in place of what the bench measures, and one beneath.
#pragma once

#include <QObject>
#include <optional>

#include "commission/known.h"
#include "friction/friction_map.h"
#include "project/run.h"

namespace breakaway {

struct KeptMap {
  ProjectRun run;
  FrictionMap map;
};

class ShownMaps : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// In place of today's; nothing: today's.
  const std::optional<KeptMap>& opened() const { return opened_; }
  /// Beneath it.
  const std::optional<KeptMap>& earlier() const { return earlier_; }
  void open(const std::optional<KeptMap>& map);
  void layBeneath(const std::optional<KeptMap>& map);

 signals:
  void changed();

 private:
  std::optional<KeptMap> opened_, earlier_;
};

/// As much of a commissioning as its map tells.
Commission commissionOf(const FrictionMap& map);

}  // namespace breakaway
