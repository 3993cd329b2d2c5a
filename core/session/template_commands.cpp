#include "core/session/template_commands.h"

#include "core/analysis/facetted.h"
#include "core/base/units.h"
#include "core/interaction/template_words.h"
#include "core/io/template_file.h"
#include "core/model/edits.h"
#include "core/model/template_edits.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"
#include "core/session/template_making.h"
#include "core/session/template_parameters.h"
#include "core/templates/flat_template.h"
#include "core/templates/moved_template.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kPercent = 100.0;
constexpr int kMostSeed = 999'999'999;

const char *kindWord(TemplateKind kind)
{
    switch (kind) {
    case TemplateKind::Mesh:
        return QT_TRANSLATE_NOOP("Error", "a mesh");
    case TemplateKind::Picture:
        return QT_TRANSLATE_NOOP("Error", "a picture");
    case TemplateKind::Curves:
        return QT_TRANSLATE_NOOP("Error", "a drawing");
    }
    return ""; // not reached: every kind is above
}

class TemplateCommands
{
public:
    TemplateCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> add(const CommandParameters &parameters, double time) const
    {
        const std::string *file = textOf(parameters, "file");
        if (!file)
            return failure(ErrorCode::BadValue, "file", {"nothing", "the name of a file"});
        io::TemplateFileOptions options;
        const Result<double> size = numberOf(parameters, "size", 0.0);
        const Result<bool> isByReference = truthOf(parameters, "reference", false);
        if (!size)
            return tl::unexpected(size.error());
        if (!isByReference)
            return tl::unexpected(isByReference.error());
        if (textOf(parameters, "size") && !(*size > 0.0))
            return failure(ErrorCode::BadValue, "size",
                           {*textOf(parameters, "size"), "a length above 0 mm"});
        options.size = *size;
        options.isByReference = *isByReference;
        if (const std::string *up = textOf(parameters, "up")) {
            if (*up != "y" && *up != "z")
                return failure(ErrorCode::BadValue, "up", {*up, "y or z"});
            options.up = *up == "z" ? UpAxis::Z : UpAxis::Y;
        }
        const Result<io::LoadedTemplate> loaded =
            io::readTemplateFile(QString::fromStdString(*file), options);
        if (!loaded)
            return tl::unexpected(loaded.error());
        Result<EditedSections> added = addedTemplate(m_session.committed().document, *loaded);
        if (!added)
            return tl::unexpected(std::move(added.error()));
        m_interaction.carryOut(SectionEdit(*std::move(added)), time);
        return {};
    }

    Result<void> refill(const CommandParameters &parameters, double time) const
    {
        const Result<Template> one = templateOf(parameters);
        const std::string *file = textOf(parameters, "file");
        if (!one)
            return tl::unexpected(one.error());
        if (!file)
            return failure(ErrorCode::BadValue, "file", {"nothing", "the name of a file"});
        const Result<bool> isByReference = truthOf(parameters, "reference", one->blob.empty());
        if (!isByReference)
            return tl::unexpected(isByReference.error());
        io::TemplateFileOptions options;
        options.isByReference = *isByReference;
        const Result<io::LoadedTemplate> loaded =
            io::readTemplateFile(QString::fromStdString(*file), options);
        if (!loaded)
            return tl::unexpected(loaded.error());
        Result<EditedSections> refilled =
            refilledTemplate(m_session.committed().document, one->id, *loaded);
        if (!refilled)
            return tl::unexpected(std::move(refilled.error()));
        m_interaction.carryOut(SectionEdit(*std::move(refilled)), time);
        return {};
    }

    Result<void> set(const CommandParameters &parameters, double time) const
    {
        Result<Template> one = templateOf(parameters);
        if (!one)
            return tl::unexpected(one.error());
        double size = one->mesh ? one->scale * one->mesh->mesh->size() : flatSize(*one).maxCoeff();
        const std::optional<Frame> lies = worldFrame(*one, m_session.committed());
        const double turnBefore = one->isFlat() && lies ? degrees(turnOf(*lies)) : 0.0;
        double turn = turnBefore;
        double opacity = kPercent * one->opacity;
        const double sizeBefore = size;
        Vec3 &at = one->frame.origin;
        for (const auto &[key, number] :
             {std::pair("x", &at.x()), std::pair("y", &at.y()), std::pair("z", &at.z()),
              std::pair("size", &size), std::pair("opacity", &opacity), std::pair("turn", &turn)}) {
            const Result<double> value = numberOf(parameters, key, *number);
            if (!value)
                return tl::unexpected(value.error());
            *number = *value;
        }
        if (size != sizeBefore && sizeBefore > 0.0) {
            one = sizedInPlace(*std::move(one), size, m_session.committed());
            if (!one)
                return failure(ErrorCode::BadValue, "size",
                               {*textOf(parameters, "size"), "a length that can be drawn"});
        }
        if (turn != turnBefore && !(one->isFlat() && lies))
            return failure(ErrorCode::BadValue, "turn",
                           {*textOf(parameters, "turn"), "nothing: this does not lie flat"});
        if (turn != turnBefore)
            *one = turned(*one, radians(turn - turnBefore));
        if (const Result<void> done = turnMesh(parameters, *one); !done)
            return done;
        if (opacity != kPercent * one->opacity)
            one->opacity = opacity / kPercent;
        for (const auto &[key, flag] :
             {std::pair("hidden", &one->isHidden), std::pair("locked", &one->isLocked),
              std::pair("flipped", &one->isFlipped)}) {
            const Result<bool> truth = truthOf(parameters, key, *flag);
            if (!truth)
                return tl::unexpected(truth.error());
            *flag = *truth;
        }
        if (const std::string *name = textOf(parameters, "name"))
            one->name = *name;
        return commit(*std::move(one), steps::kChangeTemplate, time);
    }

    Result<void> remove(const CommandParameters &parameters, double time) const
    {
        const Result<Template> one = templateOf(parameters);
        if (!one)
            return tl::unexpected(one.error());
        Result<Document> next = removeTemplate(m_session.committed().document, one->id);
        if (!next)
            return tl::unexpected(next.error());
        m_interaction.carryOut(
            EditedSections{*std::move(next), {steps::kRemoveTemplate, {Named{one->name}}}}, time);
        return {};
    }

    Result<void> toGround(const CommandParameters &parameters, double time) const
    {
        const Result<Template> one = templateOf(parameters);
        if (one && one->isFlat())
            return commit(flatOnGround(*one), steps::kMoveTemplate, time);
        return changeMesh(parameters, time,
                          [](const Template &mesh) { return onGround(mesh, *mesh.mesh); });
    }

    /// About where it stands.
    Result<void> turnUp(const CommandParameters &parameters, double time) const
    {
        return changeMesh(parameters, time, [](const Template &one) {
            const bool isYUp = one.frame.y.y() > 0.5;
            Template next = stood(one, *one.mesh, isYUp ? UpAxis::Z : UpAxis::Y, 0.0);
            next.scale = one.scale;
            next.frame.origin.x() = one.frame.origin.x();
            next.frame.origin.z() = one.frame.origin.z();
            return onGround(next, *one.mesh);
        });
    }

    /// What is not as it was wanted is said; where nothing comes of it, as the refusal.
    Result<void> suggest(const CommandParameters &parameters, double time) const
    {
        const Result<Template> one = templateOf(parameters);
        if (!one)
            return tl::unexpected(one.error());
        const Result<int> count = wholeOf(parameters, "count", 8, 1, kMostSuggested);
        const Result<int> seed = wholeOf(parameters, "seed", 1, 0, kMostSeed);
        if (!count)
            return tl::unexpected(count.error());
        if (!seed)
            return tl::unexpected(seed.error());
        Result<SectionEdit> made = suggestedEdit(m_session.committed(), one->id,
                                                 {*count, static_cast<std::uint64_t>(*seed)});
        if (!made)
            return tl::unexpected(std::move(made.error()));
        m_interaction.carryOut(*std::move(made), time);
        return {};
    }

    Result<void> facets(const CommandParameters &parameters, double time) const
    {
        return ofFaces(parameters, time, facetEdit);
    }

    Result<void> net(const CommandParameters &parameters, double time) const
    {
        return ofFaces(parameters, time, netEdit);
    }

private:
    using FacesEdit = Result<SectionEdit> (*)(const Document &, TemplateId, std::size_t,
                                              const LongWork &);

    /// To the angles that are given, each by itself.
    static Result<void> turnMesh(const CommandParameters &parameters, Template &one)
    {
        const Vec3 before = one.isFlat() ? Vec3(Vec3::Zero()) : turnsOf(one);
        Vec3 turns = before;
        int axis = 0;
        for (const char *key : {"turnX", "turnY", "turnZ"}) {
            if (const std::string *text = textOf(parameters, key); text && one.isFlat())
                return failure(ErrorCode::BadValue, key, {*text, "nothing: this lies flat"});
            const Result<double> value = numberOf(parameters, key, degrees(before[axis]));
            if (!value)
                return tl::unexpected(value.error());
            if (textOf(parameters, key))
                turns[axis] = radians(*value);
            ++axis;
        }
        if (turns != before)
            one = turnedTo(std::move(one), turns);
        return {};
    }

    Result<void> ofFaces(const CommandParameters &parameters, double time, FacesEdit edit) const
    {
        const Result<Template> one = templateOf(parameters);
        if (!one)
            return tl::unexpected(one.error());
        const Result<int> faces =
            wholeOf(parameters, "faces", int(kMostFacets), int(kFewestFaces), int(kMostFacets));
        if (!faces)
            return tl::unexpected(faces.error());
        Result<SectionEdit> made =
            edit(m_session.committed().document, one->id, static_cast<std::size_t>(*faces), {});
        if (!made)
            return tl::unexpected(std::move(made.error()));
        m_interaction.carryOut(*std::move(made), time);
        return {};
    }

    template <class Change>
    Result<void> changeMesh(const CommandParameters &parameters, double time, Change change) const
    {
        const Result<Template> one = templateOf(parameters);
        if (!one)
            return tl::unexpected(one.error());
        if (!one->mesh)
            return failure(ErrorCode::BadValue, "template", {one->name, "a mesh that is there"});
        return commit(change(*one), steps::kMoveTemplate, time);
    }

    Result<void> commit(const Template &changed, Text step, double time) const
    {
        Result<EditedSections> edit =
            changedTemplate(m_session.committed().document, changed, step);
        if (!edit)
            return tl::unexpected(std::move(edit.error()));
        m_interaction.carryOut(SectionEdit(*std::move(edit)), time);
        return {};
    }

    Result<Template> templateOf(const CommandParameters &parameters) const
    {
        return fff::templateOf(m_session.committed().document, parameters);
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

Result<EditedSections> addedTemplate(const Document &document, const io::LoadedTemplate &loaded)
{
    Result<Document> next = loaded.addedTo(document);
    if (!next)
        return tl::unexpected(std::move(next.error()));
    const std::string name = next->templates.back()->name;
    return EditedSections{*std::move(next), {steps::kAddTemplate, {Named{name}}}};
}

Result<EditedSections> refilledTemplate(const Document &document, TemplateId id,
                                        const io::LoadedTemplate &loaded)
{
    const Template *one = document.find(id);
    if (!one)
        return failure(ErrorCode::UnknownReference);
    if (loaded.made.kind != one->kind)
        return failure(ErrorCode::BadValue, loaded.made.file,
                       {kindWord(loaded.made.kind), kindWord(one->kind)});
    Template next = *one;
    next.file = loaded.made.file;
    next.blob = loaded.made.blob;
    next.mesh = loaded.made.mesh;
    next.picture = loaded.made.picture;
    next.curves = loaded.made.curves;
    return changedTemplate(loaded.blob ? addBlob(document, loaded.blob) : document, next,
                           steps::kChangeTemplate);
}

Result<EditedSections> changedTemplate(const Document &document, const Template &changed, Text step)
{
    Result<Document> next = setTemplate(document, changed);
    if (!next)
        return tl::unexpected(std::move(next.error()));
    return EditedSections{*std::move(next), {step, {Named{changed.name}}}};
}

void registerTemplateCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const TemplateCommands commands(session, interaction);
    using Run = Result<void> (TemplateCommands::*)(const CommandParameters &, double) const;
    const auto runner = [commands](Run run) {
        return [commands, run](const CommandParameters &parameters, double time) {
            return (commands.*run)(parameters, time);
        };
    };
    const CommandRule hasTemplates =
        needs([&session] { return !session.committed().document.templates.empty(); },
              FFF_TEXT("Command", "There is no template: add a mesh or a picture first"));
    registry.add("template.add", {runner(&TemplateCommands::add)});
    for (const auto &[id, run] : {std::pair("template.refill", &TemplateCommands::refill),
                                  std::pair("template.set", &TemplateCommands::set),
                                  std::pair("template.remove", &TemplateCommands::remove),
                                  std::pair("template.toGround", &TemplateCommands::toGround),
                                  std::pair("template.turnUp", &TemplateCommands::turnUp),
                                  std::pair("template.suggest", &TemplateCommands::suggest),
                                  std::pair("template.facets", &TemplateCommands::facets),
                                  std::pair("template.net", &TemplateCommands::net)})
        registry.add(id, {runner(run), hasTemplates});
}

} // namespace fff
