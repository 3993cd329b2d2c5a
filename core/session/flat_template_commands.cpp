#include "core/session/flat_template_commands.h"

#include "core/base/units.h"
#include "core/interaction/size_line_tool.h"
#include "core/interaction/template_drawing.h"
#include "core/interaction/template_tool.h"
#include "core/interaction/template_words.h"
#include "core/model/template_edits.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"
#include "core/session/template_commands.h"
#include "core/session/template_parameters.h"
#include "core/templates/moved_template.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace fff {

namespace {

constexpr CommandWords kTemplateWords[] = {
    {"template.transform", FFF_TEXT("Command", "Move a te&mplate"), FFF_TEXT("Command", "Handles"),
     "", "transform",
     FFF_TEXT("Command", "Move, turn and scale the template with handles or numbers"), true},
    {"template.sizeByLine", FFF_TEXT("Command", "Size a template by a &line"),
     FFF_TEXT("Command", "Size by a line"), "", "dimension",
     FFF_TEXT("Command", "Draw a line over the template and say how long it is"), true},
};

constexpr double kOfHundred = 100.0;
constexpr int kMostSpeckle = 1'000'000; // px²

/// The place of a word in a list of those that can be said.
template <std::size_t N>
Result<std::size_t> wordOf(const CommandParameters &parameters, const char *key,
                           const std::array<const char *, N> &words)
{
    const std::string *text = textOf(parameters, key);
    if (!text)
        return std::size_t(0);
    const auto found = std::find(words.begin(), words.end(), *text);
    if (found != words.end())
        return static_cast<std::size_t>(found - words.begin());
    std::string expected = words.front();
    for (std::size_t i = 1; i < N; ++i)
        expected += (i + 1 == N ? " or " : ", ") + std::string(words[i]);
    return failure(ErrorCode::BadValue, key, {*text, expected});
}

Result<double> percentOf(const CommandParameters &parameters, const char *key, double otherwise)
{
    const Result<double> percent = numberOf(parameters, key, kOfHundred * otherwise);
    if (percent && !(*percent >= 0.0 && *percent <= kOfHundred))
        return failure(ErrorCode::BadValue, key,
                       {*textOf(parameters, key), "a percentage from 0 to 100"});
    return percent ? *percent / kOfHundred : percent;
}

Result<PictureTrace> traceOf(const CommandParameters &parameters)
{
    PictureTrace trace;
    const auto by = wordOf(parameters, "by", std::array<const char *, 2>{"darkness", "opacity"});
    const Result<double> threshold = percentOf(parameters, "threshold", 0.0);
    const Result<double> smoothing = percentOf(parameters, "smoothing", trace.smoothing);
    const Result<int> smallest = wholeOf(parameters, "smallest", trace.smallest, 0, kMostSpeckle);
    const Result<bool> isInverted = truthOf(parameters, "inverted", false);
    if (!by)
        return tl::unexpected(by.error());
    for (const auto *number : {&threshold, &smoothing})
        if (!*number)
            return tl::unexpected(number->error());
    if (!smallest)
        return tl::unexpected(smallest.error());
    if (!isInverted)
        return tl::unexpected(isInverted.error());
    trace.by = *by == 1 ? TraceBy::Opacity : TraceBy::Darkness;
    if (textOf(parameters, "threshold"))
        trace.threshold = *threshold;
    trace.smoothing = *smoothing;
    trace.smallest = *smallest;
    trace.isInverted = *isInverted;
    return trace;
}

class FlatTemplateCommands
{
public:
    FlatTemplateCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> lay(const CommandParameters &parameters, double time) const
    {
        const Result<Template> one = flatOf(parameters, "template");
        if (!one)
            return tl::unexpected(one.error());
        const auto plane = wordOf(
            parameters, "plane", std::array<const char *, 4>{"front", "side", "ground", "section"});
        if (!plane)
            return tl::unexpected(plane.error());
        if (*plane < 3) {
            constexpr std::array kPlanes{StandardPlane::Front, StandardPlane::Side,
                                         StandardPlane::Ground};
            return commit(laidOn(*one, kPlanes[*plane]), time);
        }
        const Result<SectionRef> ref = sectionOf(parameters, {});
        if (!ref)
            return tl::unexpected(ref.error());
        return commit(laidOn(*one, *m_session.committed().find(*ref)), time);
    }

    Result<void> transform(const CommandParameters &parameters, double time) const
    {
        return pickUp<TemplateTool>(parameters, time);
    }

    Result<void> sizeByLine(const CommandParameters &parameters, double time) const
    {
        constexpr std::array<const char *, 5> kOfLine{"x1", "y1", "x2", "y2", "length"};
        if (std::none_of(kOfLine.begin(), kOfLine.end(),
                         [&](const char *key) { return textOf(parameters, key) != nullptr; }))
            return pickUp<SizeLineTool>(parameters, time);
        const Result<Template> one = flatOf(parameters, "template");
        if (!one)
            return tl::unexpected(one.error());
        std::array<double, 5> numbers{};
        for (std::size_t i = 0; i < kOfLine.size(); ++i) {
            const Result<double> number = numberOf(parameters, kOfLine[i], 0.0);
            if (!number)
                return tl::unexpected(number.error());
            numbers[i] = *number;
        }
        const Model &model = m_session.committed();
        const Section *section = model.find(one->on);
        const auto inWorld = [&](double x, double y) {
            const Vec3 place = one->frame.toWorld(Vec2(x, y));
            return section ? placementOf(section->frame)(place) : place;
        };
        Result<Template> sized = sizedByLine(*one, inWorld(numbers[0], numbers[1]),
                                             inWorld(numbers[2], numbers[3]), numbers[4], model);
        if (!sized)
            return failure(ErrorCode::BadValue, sized.error().place,
                           {"", sized.error().place == "line" ? "two places that are apart"
                                                              : "a length that can be drawn"});
        return commit(*sized, time);
    }

    Result<void> align(const CommandParameters &parameters, double time) const
    {
        const Document &document = m_session.committed().document;
        const auto by = wordOf(parameters, "by", std::array<const char *, 2>{"drawn", "all"});
        if (!by)
            return tl::unexpected(by.error());
        CommandParameters named = parameters;
        if (!textOf(parameters, "front") && document.templates.size() >= 2)
            named["front"] = document.templates[document.templates.size() - 2]->name;
        const Result<Template> front = flatOf(named, "front"), side = flatOf(named, "side");
        if (!front)
            return tl::unexpected(front.error());
        if (!side)
            return tl::unexpected(side.error());
        if (front->id == side->id)
            return failure(ErrorCode::BadValue, "side", {side->name, "another template"});
        Result<EditedSections> edit = alignedTemplates(document, *front, *side, *by == 0);
        if (!edit)
            return tl::unexpected(std::move(edit.error()));
        m_interaction.carryOut(SectionEdit(*std::move(edit)), time);
        return {};
    }

    /// What comes to nothing says so, as other edits of sections do.
    Result<void> trace(const CommandParameters &parameters, double time) const
    {
        const Result<Template> one = flatOf(parameters, "template");
        if (!one)
            return tl::unexpected(one.error());
        const auto as = wordOf(
            parameters, "as",
            std::array<const char *, 5>{"sections", "contour", "holes", "engraved", "scored"});
        const Result<PictureTrace> wanted = traceOf(parameters);
        if (!as)
            return tl::unexpected(as.error());
        if (!wanted)
            return tl::unexpected(wanted.error());
        constexpr std::array kAs{DrawingAs::Sections, DrawingAs::Contour, DrawingAs::Holes,
                                 DrawingAs::Engraved, DrawingAs::Scored};
        SectionRef section;
        if (kAs[*as] != DrawingAs::Sections) {
            const Result<SectionRef> ref = sectionOf(parameters, one->on);
            if (!ref)
                return tl::unexpected(ref.error());
            section = *ref;
        }
        const Model &model = m_session.committed();
        const Result<Drawing> drawing = drawingOf(model, *one, *wanted);
        if (!drawing)
            return tl::unexpected(drawing.error());
        const InteractionSettings &settings = m_interaction.settings();
        m_interaction.layDown(time);
        m_interaction.carryOut(madeOfDrawing(model, *drawing, kAs[*as], section,
                                             {settings.cutsAtGround, settings.naming, {}}),
                               time);
        return {};
    }

private:
    template <class InHand>
    Result<void> pickUp(const CommandParameters &parameters, double time) const
    {
        const Result<Template> one = templateOf(m_session.committed().document, parameters);
        if (!one)
            return tl::unexpected(one.error());
        m_interaction.pickUp(std::make_unique<InHand>(one->id), time);
        return {};
    }

    Result<Template> flatOf(const CommandParameters &parameters, const char *key) const
    {
        Result<Template> one = templateOf(m_session.committed().document, parameters, key);
        if (one && !(one->isFlat() && one->isRead()))
            return failure(ErrorCode::BadValue, key,
                           {one->name, "a picture or a drawing that is there"});
        return one;
    }

    /// By its name; else the one that is given; else the one in focus.
    Result<SectionRef> sectionOf(const CommandParameters &parameters, const SectionRef &given) const
    {
        const Model &model = m_session.committed();
        const std::string *name = textOf(parameters, "section");
        for (std::size_t i = 0; name && i < model.sectionCount(); ++i)
            if (model.nameOf(model.ref(i)) == *name)
                return model.ref(i);
        if (name)
            return failure(ErrorCode::BadValue, "section", {*name, "a section"});
        return sectionToDrawOn(model, given, m_interaction.sectionsInFocus());
    }

    Result<void> commit(const Template &changed, double time) const
    {
        Result<EditedSections> edit =
            changedTemplate(m_session.committed().document, changed, steps::kMoveTemplate);
        if (!edit)
            return tl::unexpected(std::move(edit.error()));
        m_interaction.carryOut(SectionEdit(*std::move(edit)), time);
        return {};
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

Result<SectionRef> sectionToDrawOn(const Model &model, const SectionRef &liesOn,
                                   const std::vector<SectionRef> &inFocus)
{
    if (model.find(liesOn))
        return liesOn;
    if (inFocus.size() == 1)
        return inFocus.front();
    return failure(ErrorCode::BadValue, "section", {"", "a section"});
}

Result<EditedSections> alignedTemplates(const Document &document, const Template &front,
                                        const Template &side, bool isByDrawn)
{
    const auto boxOf = [isByDrawn](const Template &one) {
        const Vec2 half = 0.5 * flatExtent(one);
        return isByDrawn ? drawnBox(one) : Box2{-half, half};
    };
    const auto pair = aligned(front, boxOf(front), side, boxOf(side));
    if (!pair)
        return failure(ErrorCode::BadValue, pair.error().place,
                       {"", "a picture of which something is seen"});
    Result<Document> next = setTemplate(document, pair->first);
    if (next)
        next = setTemplate(*std::move(next), pair->second);
    if (!next)
        return tl::unexpected(std::move(next.error()));
    return EditedSections{*std::move(next),
                          {steps::kAlignTemplates, {Named{front.name}, Named{side.name}}}};
}

void registerFlatTemplateCommands(CommandRegistry &registry, Session &session,
                                  Interaction &interaction)
{
    const FlatTemplateCommands commands(session, interaction);
    using Run = Result<void> (FlatTemplateCommands::*)(const CommandParameters &, double) const;
    const CommandRule hasFlat = needs(
        [&session] {
            const auto &all = session.committed().document.templates;
            return std::any_of(all.begin(), all.end(),
                               [](const TemplatePointer &one) { return one->isFlat(); });
        },
        FFF_TEXT("Command", "There is no picture and no drawing: add one first"));
    for (const auto &[id, run] : {std::pair("template.lay", Run(&FlatTemplateCommands::lay)),
                                  std::pair("template.align", Run(&FlatTemplateCommands::align)),
                                  std::pair("template.trace", Run(&FlatTemplateCommands::trace))})
        registry.add(id, {[commands, run = run](const CommandParameters &parameters, double time) {
                              return (commands.*run)(parameters, time);
                          },
                          hasFlat});
    const CommandRule hasAny =
        needs([&session] { return !session.committed().document.templates.empty(); },
              FFF_TEXT("Command", "There is no template: add a mesh or a picture first"));
    for (const auto &[id, run] :
         {std::pair("template.transform", Run(&FlatTemplateCommands::transform)),
          std::pair("template.sizeByLine", Run(&FlatTemplateCommands::sizeByLine))})
        registry.add(id, {[commands, run = run](const CommandParameters &parameters, double time) {
                              return (commands.*run)(parameters, time);
                          },
                          hasAny, inHand(interaction, id)});
    registry.offer(kTemplateWords);
}

} // namespace fff
