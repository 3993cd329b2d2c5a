#include "core/session/copy_commands.h"

#include "core/interaction/pick_section_tool.h"
#include "core/interaction/section_editing.h"
#include "core/io/fff_format.h"
#include "core/operations/excerpt.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

#include <algorithm>
#include <memory>

namespace fff {

namespace {

constexpr CommandWords kCopyWords[] = {
    {"edit.cut", FFF_TEXT("Command", "Cu&t"), FFF_TEXT("Command", "Cut"), "Ctrl+X", "cut",
     FFF_TEXT("Command", "Copy the selected sections and delete them")},
    {"edit.copy", FFF_TEXT("Command", "&Copy"), FFF_TEXT("Command", "Copy"), "Ctrl+C", "copy",
     FFF_TEXT("Command", "Copy the selected sections, also for other windows and programs")},
    {"edit.paste", FFF_TEXT("Command", "&Paste"), FFF_TEXT("Command", "Paste"), "Ctrl+V", "paste",
     FFF_TEXT("Command", "Add the sections that were copied, or a picture to draw over")},
    {"edit.duplicate", FFF_TEXT("Command", "Dup&licate"), FFF_TEXT("Command", "Duplicate"),
     "Ctrl+D", "duplicate", FFF_TEXT("Command", "Put a copy of the selected sections beside them")},
    {"edit.mirrorCopyX", FFF_TEXT("Command", "Across &X"), FFF_TEXT("Command", "Mirror X"), "",
     "mirror_copy",
     FFF_TEXT("Command",
              "Put a mirror image of the selected sections on the other side of the plane "
              "where X is 0")},
    {"edit.mirrorCopyY", FFF_TEXT("Command", "Across &Y"), FFF_TEXT("Command", "Mirror Y"), "",
     "mirror_copy",
     FFF_TEXT("Command",
              "Put a mirror image of the selected sections on the other side of the plane "
              "where Y is 0")},
    {"edit.mirrorCopyZ", FFF_TEXT("Command", "Across &Z"), FFF_TEXT("Command", "Mirror Z"), "",
     "mirror_copy",
     FFF_TEXT("Command",
              "Put a mirror image of the selected sections on the other side of the plane "
              "where Z is 0")},
    {"edit.mirrorCopySection", FFF_TEXT("Command", "Across a &section…"),
     FFF_TEXT("Command", "Mirror"), "", "mirror_copy",
     FFF_TEXT("Command",
              "Click a section: a mirror image of the selected ones comes on its other side")},
};

//: %1 is the name of a section
constexpr CountedText kCutSections{FFF_TEXT("Step", "Cut %1"),
                                   FFF_TEXT_OF_MANY("Step", "Cut %n sections")};
//: %1 is the name of a section
constexpr CountedText kPasteSections{FFF_TEXT("Step", "Paste %1"),
                                     FFF_TEXT_OF_MANY("Step", "Paste %n sections")};
constexpr Text kPickMirror = FFF_TEXT(
    "Hint", "Click the section to mirror across; drag to turn the view. <kbd>Esc</kbd> cancels.");

/// How far a copy stands beside what it is a copy of, mm (half an inch).
constexpr double kBeside = 12.7;
/// So often it goes on from there before it stays where something else is.
constexpr int kMostSteps = 200;
/// Frames that differ by less are one place, mm: what is copied has gone through a file.
constexpr double kSamePlace = 1e-6;

bool isAt(const Section &a, const Section &b, const Vec3 &way)
{
    return (a.frame.origin + way - b.frame.origin).norm() <= kSamePlace &&
           (a.frame.x - b.frame.x).norm() <= kSamePlace &&
           (a.frame.y - b.frame.y).norm() <= kSamePlace &&
           (a.shape == b.shape || *a.shape == *b.shape);
}

class CopyCommands
{
public:
    CopyCommands(Session &session, Interaction &interaction, Clipboard clipboard)
        : m_session(session), m_interaction(interaction), m_clipboard(std::move(clipboard))
    {
    }

    Result<void> copy() const
    {
        const Result<std::string> text = io::writeFff(excerpt(model(), chosen()));
        if (!text)
            return tl::unexpected(text.error());
        m_clipboard.write(*text);
        return {};
    }

    Result<void> cut(double time) const
    {
        SectionEdit edit = deleted(model(), chosen(), &kCutSections);
        if (edit)
            if (const Result<void> copied = copy(); !copied)
                return copied;
        m_interaction.carryOut(std::move(edit), time);
        return {};
    }

    Result<void> paste(double time) const
    {
        const Result<io::LoadedDocument> read = io::readFff(m_clipboard.read());
        if (!read || read->document.sections.empty()) {
            m_interaction.say(Hint::refusal(hints::kNothingToPaste), time);
            return {};
        }
        std::vector<std::string> names;
        for (const SectionPointer &section : read->document.sections)
            names.push_back(section->name);
        m_interaction.carryOut(added(model(), read->document, freeWay(read->document),
                                     ofSections(kPasteSections, names)),
                               time);
        return {};
    }

    Result<void> duplicate(double time) const
    {
        const std::vector<SectionRef> sections = chosen();
        const Vec3 way = kBeside * sideways(*model().find(m_interaction.sectionsInFocus().back()));
        m_interaction.carryOut(duplicated(model(), sections, way), time);
        return {};
    }

    Result<void> mirror(const Vec3 &normal, double time) const
    {
        m_interaction.carryOut(mirroredCopy(model(), chosen(), Vec3::Zero(), normal), time);
        return {};
    }

    Result<void> mirrorAcross(const CommandParameters &parameters, double time) const
    {
        const std::vector<SectionRef> sections = chosen();
        const auto edit = [sections](const Model &model, const SectionRef &across) {
            const Frame &frame = model.find(across)->frame;
            return mirroredCopy(model, sections, frame.origin, frame.normal());
        };
        const std::string *name = textOf(parameters, "section");
        if (!name) {
            m_interaction.pickUp(std::make_unique<PickSectionTool>("edit.mirrorCopySection",
                                                                   Hint(kPickMirror), edit),
                                 time);
            return {};
        }
        const auto &all = model().sections();
        const auto across = std::find_if(
            all.begin(), all.end(), [name](const auto &section) { return section->name == *name; });
        if (across == all.end())
            return failure(ErrorCode::BadValue, "section", {*name, "the name of a section"});
        m_interaction.carryOut(edit(model(), (*across)->ref()), time);
        return {};
    }

private:
    const Model &model() const { return m_session.committed(); }

    /// Of a selected operation also what it is made of.
    std::vector<SectionRef> chosen() const
    {
        std::vector<SectionRef> sections = m_interaction.sectionsInFocus();
        if (const Operation *operation = model().document.find(m_interaction.selectedOperation()))
            for (const auto &[role, inputs] : operation->inputs)
                for (const OperationInput &input : inputs)
                    if (model().find(input.section))
                        sections.push_back(input.section);
        return sections;
    }

    /// Along the normal, to where it is seen better: right, towards the eye or up.
    Vec3 sideways(const Section &section) const
    {
        const Camera &camera = m_interaction.targetCamera();
        const Vec3 normal = section.frame.normal();
        const Vec3 seen = camera.right() + 0.5 * camera.backward() + 0.25 * camera.up();
        return seen.dot(normal) < 0.0 ? Vec3(-normal) : normal;
    }

    /// Nothing, or so far beside that it lies on none like it.
    Vec3 freeWay(const Document &pasted) const
    {
        const Vec3 step = kBeside * sideways(*pasted.sections.front());
        const auto isTaken = [&](const Vec3 &way) {
            return std::any_of(
                pasted.sections.begin(), pasted.sections.end(), [&](const SectionPointer &section) {
                    const auto &all = model().sections();
                    return std::any_of(all.begin(), all.end(), [&](const SectionPointer &other) {
                        return isAt(*section, *other, way);
                    });
                });
        };
        Vec3 way = Vec3::Zero();
        for (int i = 0; i < kMostSteps && isTaken(way); ++i)
            way += step;
        return way;
    }

    Session &m_session;
    Interaction &m_interaction;
    Clipboard m_clipboard;
};

} // namespace

Clipboard memoryClipboard()
{
    const auto text = std::make_shared<std::string>();
    return {[text] { return *text; }, [text](const std::string &next) { *text = next; }};
}

void registerCopyCommands(CommandRegistry &registry, Session &session, Interaction &interaction,
                          Clipboard clipboard)
{
    const CopyCommands commands(session, interaction, std::move(clipboard));
    const CommandRule hasSelection = needsSelection(interaction);
    registry.add(
        "edit.copy",
        {[commands](const CommandParameters &, double) { return commands.copy(); }, hasSelection});
    registry.add("edit.cut",
                 {[commands](const CommandParameters &, double time) { return commands.cut(time); },
                  hasSelection});
    registry.add("edit.paste", {[commands](const CommandParameters &, double time) {
                     return commands.paste(time);
                 }});
    registry.add("edit.duplicate", {[commands](const CommandParameters &, double time) {
                                        return commands.duplicate(time);
                                    },
                                    hasSelection});
    const std::pair<const char *, Vec3> planes[] = {{"edit.mirrorCopyX", Vec3::UnitX()},
                                                    {"edit.mirrorCopyY", Vec3::UnitY()},
                                                    {"edit.mirrorCopyZ", Vec3::UnitZ()}};
    for (const auto &[id, normal] : planes) {
        const Vec3 across = normal;
        registry.add(id, {[commands, across](const CommandParameters &, double time) {
                              return commands.mirror(across, time);
                          },
                          hasSelection});
    }
    registry.add("edit.mirrorCopySection",
                 {[commands](const CommandParameters &parameters, double time) {
                      return commands.mirrorAcross(parameters, time);
                  },
                  needsAnother(session, hasSelection),
                  inHand(interaction, "edit.mirrorCopySection")});
    registry.offer(kCopyWords);
}

} // namespace fff
