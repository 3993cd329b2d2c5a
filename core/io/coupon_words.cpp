#include "core/io/coupon_words.h"

#include <QtCore/QCoreApplication>

namespace fff::io {

namespace {

// What fitCoupon() expects, for lupdate.
[[maybe_unused]] const char *const kCouponErrors[] = {
    QT_TRANSLATE_NOOP("Error", "a larger sheet"),
};

} // namespace

CouponWords couponWords()
{
    const auto text = [](const char *words) {
        return QCoreApplication::translate("Coupon", words).toStdString();
    };
    return {text(QT_TRANSLATE_NOOP("Coupon", "Slits to try")),
            text(QT_TRANSLATE_NOOP("Coupon", "Strip to push in")),
            text(QT_TRANSLATE_NOOP("Coupon", "Slat to measure"))};
}

} // namespace fff::io
