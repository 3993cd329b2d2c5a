#include "ui/view/sign_looks.h"

#include "ui/view/mark_pen.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace fff::ui {

namespace {

struct RoleLook
{
    SignRole role;
    SignLook look;
};

constexpr RoleLook kLooks[] = {
    {SignRole::Measured, {.colour = &ViewStyle::accent}},
    {SignRole::Dimension, {.colour = &ViewStyle::text, .width = 1.2}},
    {SignRole::Place, {.colour = &ViewStyle::guide}},
    {SignRole::Figure, {.colour = &ViewStyle::accent}},
    {SignRole::Refused, {.colour = &ViewStyle::warning, .dash = 4.0, .gap = 3.0}},
    {SignRole::Plane,
     {.colour = &ViewStyle::guide,
      .width = 1.6,
      .dash = 6.0,
      .gap = 4.0,
      .fill = 0.08,
      .isCased = false}},
    {SignRole::DeadZone,
     {.colour = &ViewStyle::deadZone,
      .width = 1.4,
      .dash = 4.0,
      .gap = 3.0,
      .fill = 0.13,
      .isCased = false}},
    {SignRole::Slit, {.colour = &ViewStyle::slit, .fill = 0.45}},
    {SignRole::Offer, {.colour = &ViewStyle::guide, .width = 1.6, .dash = 6.0, .gap = 4.0}},
    {SignRole::Guide, {.colour = &ViewStyle::guide, .width = 1.4, .dash = 4.0, .gap = 3.0}},
    {SignRole::Cue, {.colour = &ViewStyle::text}},
    {SignRole::Doubt, {.colour = &ViewStyle::warning}},
    {SignRole::Load, {.colour = &ViewStyle::text, .radius = 4.5}},
    {SignRole::Traced, {.colour = &ViewStyle::guide, .width = 1.6}},
    {SignRole::Mirror,
     {.colour = &ViewStyle::symmetry,
      .width = 1.6,
      .dash = 6.0,
      .gap = 4.0,
      .fill = 0.08,
      .isCased = false}},
    {SignRole::LoadInHand, {.colour = &ViewStyle::accent, .radius = 6.0}},
};

} // namespace

const SignLook &lookOf(SignRole role)
{
    const auto found = std::find_if(std::begin(kLooks), std::end(kLooks),
                                    [role](const RoleLook &one) { return one.role == role; });
    assert(found != std::end(kLooks));
    return found->look;
}

QPen penOf(const SignLook &look, const ViewStyle &style)
{
    const QColor &colour = style.*look.colour;
    QPen pen = look.isCased ? roundPen(colour, look.width) : QPen(colour, look.width);
    if (look.dash > 0.0)
        pen.setDashPattern({look.dash, look.gap});
    return pen;
}

} // namespace fff::ui
