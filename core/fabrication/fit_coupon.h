// A test piece that tells how a stock and a machine go together: which clearance slits need, and
// how wide the machine cuts.
#pragma once

#include "core/base/result.h"
#include "core/fabrication/cutting_drawing.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace fff {

// Slits of a coupon are numbered by their width, and a number always means the same clearance: what
// a person read off an old piece stays true, whatever was set since.
inline constexpr int kCouponSlits = 13;     // 1 … 13, the narrowest first
inline constexpr double kCouponStep = 0.05; // mm, from each to the next

/// The clearance of a stock in which slit `number` fitted, mm; 0 for the one in the middle, which
/// is as wide as the stock is thick. number  1 … kCouponSlits
double clearanceOfSlit(int number);
/// The number of the slit whose clearance is next to that.
int slitOfClearance(double clearance);

/// The numbers of the slits that a stock's coupon has.
struct CouponRange
{
    int first = 1, last = kCouponSlits;
    bool operator==(const CouponRange &) const = default;
};
/// Errors  as fitCoupon().
Result<CouponRange> couponRange(const Stock &stock);

inline constexpr int kCouponSlats = 10;
inline constexpr double kCouponSlat = 10.0; // mm, width of each
/// The kerf of a machine whose slats, pushed together side by side, are that wide, mm.
double kerfOfSlats(double measured);

/// What its parts are called, for people.
struct CouponWords
{
    std::string slits = "Slits to try", strip = "Strip to push in", slat = "Slat to measure";
};

/// A sheet for each of the stocks, only as large as it takes, so that any offcut will do:
///
///   slits   a piece (part 1) with numbered slits from its edge, their paths compensated for the
///           stock's kerf as those of a model are. Engraved with the stock's name, its thickness,
///           its kerf and the machine. Numbers whose slit the kerf would close are not there, nor
///           the outermost ones where the sheet is too short for all
///   strip   of the same stock, whose edge one pushes into them (part 2)
///   slats   kCouponSlats, each kCouponSlat wide along the middle of its cut: not compensated, so
///           that what is missing of their sum when they are cut is kCouponSlats kerfs, whatever
///           kerf is set (part 3 and those behind)
///
/// Errors  ClosedSlit (stock, width, kerf) where the kerf closes the slit in the middle; BadValue,
///         place "sheet", where the stock's sheet is too small for these parts; as
///         compensateKerf()
Result<CuttingDrawing> fitCoupon(std::span<const Stock> stocks,
                                 std::shared_ptr<const Machine> machine = nullptr,
                                 const CouponWords &words = {});

} // namespace fff
