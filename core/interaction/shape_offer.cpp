#include "core/interaction/shape_offer.h"

#include "core/interaction/offer_words.h"
#include "core/stroke/meant_shape.h"

namespace fff {

namespace {

/// Below the lower edge of what was drawn, px.
constexpr double kBelow = 20.0;

struct OfferTexts
{
    Text chip, step, stepOfHole;
};

OfferTexts textsOf(MeantShape::Kind kind)
{
    switch (kind) {
    case MeantShape::Kind::Circle:
        return {hints::kOfferCircle, steps::kMakeCircle, steps::kRoundHole};
    case MeantShape::Kind::Ellipse:
        return {hints::kOfferEllipse, steps::kMakeEllipse, steps::kOvalHole};
    case MeantShape::Kind::StraightLines:
        return {hints::kOfferStraight, steps::kStraightenLines, steps::kStraightenLines};
    case MeantShape::Kind::RightAngles:
        break;
    }
    return {hints::kOfferRightAngles, steps::kMakeRightAngles, steps::kMakeRightAngles};
}

/// Its lowest place on the canvas, in the middle.
Vec3 below(const Contour &drawn, const Frame &canvas)
{
    const Box2 box = drawn.bounds();
    const bool isUpsideDown = canvas.y.y() < 0.0;
    return canvas.toWorld({box.center().x(), isUpsideDown ? box.max.y() : box.min.y()});
}

} // namespace

sign::Label offerChip(Text words, const Contour &drawn, const Frame &canvas)
{
    return {SignRole::Offer, {below(drawn, canvas)}, Message{words, {}}, {0.0, kBelow}};
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
    offer.document = std::move(made->document);
    offer.signs.add(sign::Curve{SignRole::Offer, target.canvas, meant->contour});
    offer.signs.add(offerChip(texts.chip, drawn, target.canvas));
    return offer;
}

} // namespace fff
