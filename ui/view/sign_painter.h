// Paints signs: each kind here, or in the file of those that are laid out by what else is seen.
#pragma once

#include "core/interaction/overlay.h"
#include "ui/view/length_unit.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

namespace fff {
struct OperationKind;
}

namespace fff::ui {

void paintSign(MarkPen &pen, const sign::Line &line);
void paintSign(MarkPen &pen, const sign::Outlines &outlines);
void paintSign(MarkPen &pen, const sign::Curve &curve);
void paintSign(MarkPen &pen, const sign::Handle &handle);
/// One that is an offer is a button.
/// told   where its words come to be, px; may be null
/// isLit  the cursor is on it
void paintSign(MarkPen &pen, const sign::Label &label, LengthUnit unit, const QLocale &locale,
               QRectF *told = nullptr, bool isLit = false);
void paintSign(MarkPen &pen, const sign::Region &region);
void paintSign(MarkPen &pen, const sign::Capsule &capsule);
void paintSign(MarkPen &pen, const sign::Arrow &arrow);
void paintSign(MarkPen &pen, const sign::Band &band);

/// What some kinds look at besides themselves.
struct SignScene
{
    bool isGroundHatched = false;             // what is below the ground is hatched already
    SectionPointer edited = {};               // whose points are shown, as it is shown
    const OperationKind *operation = nullptr; // whose handles there are
    LengthUnit unit = LengthUnit::Millimetre;
    QRectF *offer = nullptr; // is told where the words of an offer are
    bool isOfferLit = false; // the cursor is on them
};

/// All of them, what lies under others first, whatever the order in which they came. Leaves the
/// painter's state changed.
void paintSigns(MarkPen &pen, const std::vector<const Signs *> &all, const SignScene &scene,
                const QLocale &locale);

} // namespace fff::ui
