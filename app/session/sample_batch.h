// Samples on their way from the I/O thread to whoever shows them: written once, then only read.
#pragma once

#include <QMetaType>
#include <cstddef>
#include <memory>
#include <vector>

#include "recording/sample.h"

namespace breakaway {

struct SampleBatch {
  std::vector<Sample> samples;
  size_t lost = 0;  ///< samples that the link lost in this stretch
};

using SampleBatchPtr = std::shared_ptr<const SampleBatch>;

}  // namespace breakaway

Q_DECLARE_METATYPE(breakaway::SampleBatchPtr)
