// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_PEAKS_H
#define RODPACK_STUDY_PEAKS_H

#include <vector>

#include "ensemble/ensemble.h"

namespace rodpack {

/// A peak of a curve with bins of equal width.
struct Peak {
  double position = 0, position_error = 0;  // in the unit of the abscissa
  EnsembleMean height;                      // of the highest bin
  double prominence = 0;                    // above the higher one of the lows beside it
  double prominence_error = 0;
};

/// Standard errors by which the prominence of a peak exceeds 0. The lows beside a peak are the
/// lowest of many bins: in a hundred bins of noise alone, 3 find a peak two times in three, 5 in
/// less than one of fifty for three runs.
constexpr double peak_significance = 5;

/// Finds the peaks of a mean over repetitions, in ascending order. A bin is a peak when it
/// is higher than both its neighbours and stands out of the noise: its prominence is
/// more than 5 of its standard errors. Prominence: the height above the higher of the two lows that
/// lie between it and the next higher bin, or the end, to its left and right. Standard error of a
/// bin: the root mean square over the bins within half a unit of the abscissa, since that of a
/// single bin, from few repetitions, may be small by chance; those of peak and low add in squares.
/// Position: vertex of the parabola through the highest bin and its neighbours; its error, from
/// those of the three bins, to first order.
/// @return none for a curve of single repetitions, whose noise is not known.
std::vector<Peak> find_peaks(const EnsembleCurve& curve);

}  // namespace rodpack

#endif
