#include "core/assembly/joint_editing.h"
#include "core/interaction/offer_words.h"
#include "core/interaction/stroke_gesture.h"
#include "core/interaction/stroke_words.h"
#include "core/operations/evaluate.h"

namespace fff {

namespace {

/// The document, the slit of the section that was drawn on opening where the stroke left it: of two
/// that go all through each other nothing else says from which side one slides in. way: world
Document openedTowards(Document document, const Model &before, const SectionRef &ground,
                       const Vec3 &way, const SectionRef &drawn)
{
    const Model model = evaluate(document, before);
    const JointRef joint(ground, drawn);
    const auto state = jointState(model, joint);
    if (!state || !state->canFlip)
        return document;
    const Vec3 opening = joint.b == ground ? state->openingOfB() : Vec3(-state->openingOfB());
    if (opening.dot(way) >= 0.0)
        return document;
    const JointEdit flipped = flipSlits(model, joint);
    return flipped ? flipped->document : document;
}

} // namespace

// What a stroke has to do with templates: their guides on the plane that it draws on.

/// While the slit is drawn they move with it: what its plane would cut.
void StrokeGesture::lookAtTemplates(const GestureContext &context)
{
    const Frame &ground = m_ground->section->frame;
    const Vec3 from = ground.toWorld(m_stroke.slitFrom());
    const Vec3 way = ground.toWorld(m_stroke.slitTo()) - from;
    m_templates = TemplateGuides();
    if (context.model.document.templates.empty())
        return;
    if (const Result<Frame> canvas = makeFrame(from, way, ground.normal()))
        m_templates = TemplateGuides(context.model, context.pulled.get(), *canvas);
}

/// From the moment that the plane is known.
void StrokeGesture::followTemplates(const GestureContext &context)
{
    m_templates = TemplateGuides(context.model, context.pulled.get(), m_target.canvas);
    const Template *followed = m_templates.followed(context.model.document);
    m_followed = followed ? followed->name : std::string();
    m_canFollow = followed && context.settings.snaps;
    if (m_canFollow)
        m_stroke.setGuides(m_templates.curves(
            guideReach(context.settings.guideReach, context.camera.millimetresPerPixel)));
}

bool StrokeGesture::hasGuide() const
{
    return m_stroke.state() != Stroke::State::Slit &&
           m_templates.canTake(m_ground ? m_stroke.slitLength() : 0.0);
}

/// In place of all that was drawn so far.
GestureReply StrokeGesture::takeGuide(GestureContext &context)
{
    const bool hasSlit = m_ground.has_value();
    const auto whole = m_templates.whole(hasSlit ? m_stroke.slitLength() : 0.0);
    if (!whole) {
        GestureReply reply = running();
        reply.note = Hint::refusal(hints::kNoGuideAtSlit);
        return reply;
    }
    m_drawn = drawWhole(context.model.document, m_target, *whole,
                        {context.settings.cutsAtGround, context.settings.naming, {}});
    m_stroke.cancel();
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    if (!*m_drawn) {
        reply.note = m_drawn->error();
        return reply;
    }
    reply.note = std::move((*m_drawn)->note);
    Document drawn = std::move((*m_drawn)->document);
    if (hasSlit) {
        const Frame &ground = m_ground->section->frame;
        const Vec3 way = ground.directionToWorld(m_stroke.slitTo() - m_stroke.slitFrom());
        drawn =
            openedTowards(std::move(drawn), context.model, m_ground->ref, way, (*m_drawn)->section);
    }
    reply.commit = {std::move((*m_drawn)->step), std::move(drawn)};
    if (m_quick)
        reply.settling = {m_quick->ended(context.viewport), m_quick->end() - m_now};
    return reply;
}

void StrokeGesture::addTemplates(const GestureContext &context, Signs &signs) const
{
    const bool isDrawing = m_stroke.state() == Stroke::State::Contour;
    const StrokeContour *contour = isDrawing ? &m_stroke.contour() : nullptr;
    const GuidedLine *line = contour && contour->guided ? &*contour->guided : nullptr;
    m_templates.show(line, hasGuide(), signs);
    auto *guides = signs.find<sign::Guides>();
    const Template *followed = m_templates.followed(context.model.document, line);
    if (!guides || !followed || !m_canFollow || m_stroke.state() == Stroke::State::Slit)
        return;
    sign::FollowedGuide &told = guides->followed.emplace();
    told.name = followed->name;
    told.isBegun = line && line->length > 0.0;
    if (!told.isBegun)
        return;
    // What has gone all round one is that guide.
    told.share = line->whole ? 1.0 : std::min(1.0, line->onGuides / line->length);
    told.farthest = line->whole ? 0.0 : line->farthest;
}

} // namespace fff
