#include "core/session/drawing_commands.h"

#include "core/geometry/outlines.h"
#include "core/geometry/tangle.h"
#include "core/interaction/drawing_editing.h"
#include "core/interaction/drawing_words.h"
#include "core/io/document_file.h"
#include "core/io/loaded_document.h"
#include "core/io/svg_reader.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

#include <QFileInfo>

namespace fff {

namespace {

constexpr CommandWords kDrawingWords[] = {
    {"section.importSections", FFF_TEXT("Command", "Sections from SV&G…"),
     FFF_TEXT("Command", "From SVG"), "", "import_drawing",
     FFF_TEXT("Command", "A section for every outline of a drawing")},
    {"section.importContour", FFF_TEXT("Command", "&Contour from SVG…"),
     FFF_TEXT("Command", "Contour from SVG"), "", "import_drawing",
     FFF_TEXT("Command", "The largest outline of a drawing in place of the selected section's")},
    {"section.importHoles", FFF_TEXT("Command", "&Holes from SVG…"),
     FFF_TEXT("Command", "Holes from SVG"), "", "import_drawing",
     FFF_TEXT("Command", "A hole of the selected section for every outline of a drawing")},
    {"section.importMarks", FFF_TEXT("Command", "&Marks from SVG…"),
     FFF_TEXT("Command", "Marks from SVG"), "", "import_drawing",
     FFF_TEXT("Command", "The lines of a drawing, engraved or scored on the selected section")},
};

/// The lines that count: of a file of ours no reference bars, and of its colours those that are
/// wanted.
std::vector<CurvePath> linesOf(const io::SvgDrawing &drawing, bool areMarks)
{
    std::vector<CurvePath> lines;
    for (const io::SvgDrawing::Line &line : drawing.lines) {
        const bool isCut = line.stroke == "#ff0000";
        const bool isGuide = line.stroke == "#ffcc00";
        if (!drawing.isCuttingFile || (areMarks ? !isCut && !isGuide : isCut))
            lines.push_back(line.path);
    }
    return lines;
}

/// What of a drawing came, and what was left out of it.
Hint readOf(const Drawing &drawing, const io::SvgDrawing &read)
{
    const Named name{drawing.name};
    const Message lines{hints::kLinesRead, {}, static_cast<int>(drawing.lines.size())};
    const Message texts{hints::kSkippedTexts, {}, read.texts};
    const Message pictures{hints::kSkippedPictures, {}, read.pictures};
    if (read.texts > 0 && read.pictures > 0)
        return {hints::kDrawingReadOfBoth, {name, texts, pictures, lines}};
    return {hints::kDrawingRead, {name, read.texts > 0 ? texts : pictures, lines}};
}

class DrawingCommands
{
public:
    enum class As { Sections, Contour, Holes, Marks };

    DrawingCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> read(As as, const CommandParameters &parameters, double time) const
    {
        const std::string *path = textOf(parameters, "path");
        if (!path)
            return failure(ErrorCode::BadValue, "path", {"", "the path of a drawing"});
        const QString file = QString::fromStdString(*path);
        const Result<io::SvgDrawing> read = io::readDrawing(file);
        if (!read)
            return tl::unexpected(read.error());
        const Drawing drawing{linesOf(*read, as == As::Marks),
                              QFileInfo(file).fileName().toStdString()};
        if (as != As::Marks)
            if (const double work = largestTangle(joined(drawing.lines, kDrawnGap));
                work > kMostCrossingWork)
                return failure(
                    ErrorCode::BadCount, drawing.name,
                    {io::shortNumber(work), io::shortNumber(kMostCrossingWork),
                     QT_TRANSLATE_NOOP("Error", "places where a line may cross itself")});
        SectionEdit edit =
            tl::unexpected(Hint::refusal(hints::kDrawingOpen, {Named{drawing.name}}));
        if (!drawing.lines.empty())
            edit = editOf(as, drawing);
        const bool isPassedOver = read->texts > 0 || read->pictures > 0;
        if (edit && isPassedOver && !edit->note)
            edit->note = readOf(drawing, *read);
        m_interaction.layDown(time);
        m_interaction.carryOut(std::move(edit), time);
        return {};
    }

private:
    SectionEdit editOf(As as, const Drawing &drawing) const
    {
        const Model &model = m_session.committed();
        const InteractionSettings &settings = m_interaction.settings();
        if (as == As::Sections)
            return drawingSections(model, drawing, settings.naming);
        const SectionRef section = m_interaction.sectionsInFocus().front();
        if (as == As::Contour)
            return drawingContour(model, section, drawing);
        if (as == As::Holes)
            return drawingHoles(model, section, drawing);
        return drawingMark(model, section, drawing,
                           settings.scores ? Mark::Kind::Scored : Mark::Kind::Engraved);
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

void registerDrawingCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    using As = DrawingCommands::As;
    const DrawingCommands commands(session, interaction);
    const auto add = [&](const char *id, As as) {
        registry.add(id, {[commands, as](const CommandParameters &parameters, double time) {
                              return commands.read(as, parameters, time);
                          },
                          as == As::Sections ? CommandRule() : needsOneSection(interaction)});
    };
    add("section.importSections", As::Sections);
    add("section.importContour", As::Contour);
    add("section.importHoles", As::Holes);
    add("section.importMarks", As::Marks);
    registry.offer(kDrawingWords);
}

} // namespace fff
