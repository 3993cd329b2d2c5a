#include "core/interaction/shape_offer.h"

#include "core/interaction/offer_words.h"
#include "core/stroke/meant_shape.h"

namespace fff {

namespace {

/// Below the lower edge of what was drawn, px.
constexpr double kBelow = 20.0;

struct OfferTexts
{
    Text chip, step, stepOfHole, done;
};

OfferTexts textsOf(MeantShape::Kind kind)
{
    switch (kind) {
    case MeantShape::Kind::Circle:
        return {hints::kOfferCircle, steps::kMakeCircle, steps::kRoundHole, hints::kIsCircle};
    case MeantShape::Kind::Ellipse:
        return {hints::kOfferEllipse, steps::kMakeEllipse, steps::kOvalHole, hints::kIsEllipse};
    case MeantShape::Kind::StraightLines:
        return {hints::kOfferStraight, steps::kStraightenLines, steps::kStraightenLines,
                hints::kIsStraight};
    case MeantShape::Kind::RightAngles:
        break;
    }
    return {hints::kOfferRightAngles, steps::kMakeRightAngles, steps::kMakeRightAngles,
            hints::kIsSquare};
}

/// Its lowest place on the canvas, in the middle.
Vec3 below(const Contour &drawn, const Frame &canvas)
{
    const Box2 box = drawn.bounds();
    const bool isUpsideDown = canvas.y.y() < 0.0;
    return canvas.toWorld({box.center().x(), isUpsideDown ? box.max.y() : box.min.y()});
}

/// The chip of an offer, below what was drawn.
sign::Label offerChip(Text words, const Contour &drawn, const Frame &canvas)
{
    return {SignRole::Offer, {below(drawn, canvas)}, Message{words, {}}, {0.0, kBelow}};
}

} // namespace

Signs offerSigns(Text words, const DrawnContour &made)
{
    const Section &section = *made.document.find(made.section.drawn);
    Signs signs;
    signs.add(sign::Curve{SignRole::Offer, section.frame, section.shape->contour()});
    signs.add(offerChip(words, section.shape->contour(), section.frame));
    return signs;
}

std::optional<ShapeOffer> shapeOffer(const Document &before, const ContourTarget &target,
                                     const Contour &drawn, double tolerance,
                                     const DrawingRules &rules,
                                     const std::optional<SlitToReach> &slit)
{
    std::optional<MeantShape> meant = meantShape(drawn, tolerance, rules.axis);
    if (!meant)
        return {};
    if (slit) {
        if (std::optional<Contour> reaching = withNeck(meant->contour, *slit)) {
            meant->contour = *std::move(reaching);
            meant->figure.reset();
        }
    }
    tl::expected<DrawnContour, Hint> made =
        meant->figure ? drawFigure(before, target, *meant->figure, rules)
                      : drawContour(before, target, meant->contour, rules);
    if (!made)
        return {};
    const OfferTexts texts = textsOf(meant->kind);
    const bool isHole = target.purpose == ContourTarget::Purpose::Hole;
    ShapeOffer offer;
    offer.step = {isHole ? texts.stepOfHole : texts.step, {Named{made->name}}};
    offer.done = Hint::undoable(texts.done);
    if (isHole) {
        offer.signs.add(sign::Curve{SignRole::Offer, target.canvas, meant->contour});
        offer.signs.add(offerChip(texts.chip, drawn, target.canvas));
    } else {
        offer.signs = offerSigns(texts.chip, *made); // as the ground cuts it
    }
    offer.document = std::move(made->document);
    return offer;
}

} // namespace fff
