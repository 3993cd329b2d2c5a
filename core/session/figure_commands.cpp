#include "core/session/figure_commands.h"

#include "core/base/units.h"
#include "core/interaction/figure_editing.h"
#include "core/interaction/figure_tool.h"
#include "core/interaction/section_view.h"
#include "core/model/figures.h"
#include "core/model/origin.h"
#include "core/session/command_rules.h"
#include "core/session/operation_script.h"

#include <cctype>
#include <memory>

namespace fff {

namespace {

constexpr CommandWords kFigureWords[] = {
    {"section.addShape", FFF_TEXT("Command", "&Draw a shape"), FFF_TEXT("Command", "Shape"),
     "Shift+A", "figure_draw",
     FFF_TEXT("Command", "Drag a circle, rectangle or the like out of its middle"), true},
    {"section.addCircle", FFF_TEXT("Command", "&Circle"), FFF_TEXT("Command", "Circle"), "",
     "figure_circle",
     FFF_TEXT("Command", "By numbers: a hole in the selected section, or a section of its own")},
    {"section.addEllipse", FFF_TEXT("Command", "&Ellipse"), FFF_TEXT("Command", "Ellipse"), "",
     "figure_ellipse",
     FFF_TEXT("Command", "By numbers: a hole in the selected section, or a section of its own")},
    {"section.addRectangle", FFF_TEXT("Command", "&Rectangle"), FFF_TEXT("Command", "Rectangle"),
     "", "figure_rectangle",
     FFF_TEXT("Command", "By numbers: a hole in the selected section, or a section of its own")},
    {"section.addPolygon", FFF_TEXT("Command", "&Polygon"), FFF_TEXT("Command", "Polygon"), "",
     "figure_polygon",
     FFF_TEXT("Command", "By numbers: a hole in the selected section, or a section of its own")},
    {"section.addStar", FFF_TEXT("Command", "&Star"), FFF_TEXT("Command", "Star"), "",
     "figure_star",
     FFF_TEXT("Command", "By numbers: a hole in the selected section, or a section of its own")},
    {"section.addSlot", FFF_TEXT("Command", "S&lot"), FFF_TEXT("Command", "Slot"), "",
     "figure_slot",
     FFF_TEXT("Command", "By numbers: a hole in the selected section, or a section of its own")},
};

class FigureCommands
{
public:
    FigureCommands(Session &session, Interaction &interaction)
        : m_session(session), m_interaction(interaction)
    {
    }

    Result<void> add(const FigureKind &kind, const CommandParameters &parameters, double time) const
    {
        m_interaction.settings().figure = kind.key;
        if (parameters.empty() && holdsTool()) {
            m_interaction.dropNumbers(time); // it looks at what it draws from now on
            return {};
        }
        const Result<Figure> figure = withNumbers(newFigure(kind), parameters);
        if (!figure)
            return tl::unexpected(figure.error());
        const std::string *as = textOf(parameters, "as");
        const bool hasSection = section() != nullptr;
        const std::string wanted = as ? *as : hasSection ? "hole" : "section";
        if (wanted != "section" && wanted != "hole" && wanted != "contour")
            return failure(ErrorCode::BadValue, "as", {wanted, "section, hole or contour"});
        if (wanted != "section" && !hasSection)
            return failure(ErrorCode::BadValue, "as", {wanted, "a section that is selected"});
        m_interaction.layDown(time);
        const SectionEdit made = edit(kind, *figure, wanted, parameters);
        const bool isSection = made && wanted == "section";
        m_interaction.carryOut(made, time);
        if (isSection)
            lookAtLast(time);
        return {};
    }

    Result<void> change(const CommandParameters &parameters, double time) const
    {
        const Result<double> boundary = numberOf(parameters, "boundary", 0.0);
        if (!boundary)
            return tl::unexpected(boundary.error());
        const auto origin = originOf(model(), section()->ref());
        const Figure *before =
            origin ? figureOf(*origin->section, static_cast<int>(*boundary)) : nullptr;
        if (!before)
            return failure(ErrorCode::BadValue, "boundary",
                           {std::to_string(*boundary), "a shape by numbers"});
        const Result<Figure> figure = withNumbers(*before, parameters);
        if (!figure)
            return tl::unexpected(figure.error());
        m_interaction.carryOut(
            changedFigure(model(), section()->ref(), static_cast<int>(*boundary), *figure), time);
        return {};
    }

    Result<void> draw(const CommandParameters &parameters, double time) const
    {
        if (const std::string *kind = textOf(parameters, "figure")) {
            if (!figureKind(*kind))
                return failure(ErrorCode::BadValue, "figure",
                               {*kind, "circle, ellipse, rectangle, "
                                       "polygon, star or slot"});
            m_interaction.settings().figure = *kind;
        }
        m_interaction.pickUp(std::make_unique<FigureTool>(), time);
        return {};
    }

    /// The one that is selected; null: none, or several.
    const Section *section() const
    {
        const std::vector<SectionRef> sections = m_interaction.sectionsInFocus();
        return sections.size() == 1 ? model().find(sections.front()) : nullptr;
    }

private:
    const Model &model() const { return m_session.committed(); }
    bool holdsTool() const
    {
        return m_interaction.tool() && m_interaction.tool()->command() == FigureTool::kCommand;
    }

    SectionEdit edit(const FigureKind &kind, const Figure &figure, const std::string &as,
                     const CommandParameters &parameters) const
    {
        const InteractionSettings &settings = m_interaction.settings();
        if (as == "section")
            return addedFigure(model(), figure,
                               {m_interaction.targetCamera(), m_interaction.viewport(), section()},
                               {settings.cutsAtGround, settings.naming});
        if (as == "contour")
            return figureContour(model(), section()->ref(), kind);
        return parameters.contains("x") || parameters.contains("y")
                   ? figureHole(model(), section()->ref(), figure)
                   : figureHoleInside(model(), section()->ref(), figure);
    }

    /// Unless it is seen well as the view is.
    void lookAtLast(double time) const
    {
        const std::optional<Camera> camera =
            cameraAtSection(*model().document.sections.back(), m_interaction.targetCamera(),
                            m_interaction.viewport());
        if (camera)
            m_interaction.turnTo(*camera, time, m_interaction.settings().turnTime);
    }

    /// What is not said stays.
    static Result<Figure> withNumbers(Figure figure, const CommandParameters &parameters)
    {
        const FigureKind &kind = *figureKind(figure.kind);
        for (std::size_t i = 0; i < kind.numbers.size(); ++i) {
            const Result<double> number =
                numberOf(parameters, kind.numbers[i].key, figure.numbers[i]);
            if (!number)
                return tl::unexpected(number.error());
            figure.numbers[i] = *number;
        }
        const Result<double> x = numberOf(parameters, "x", figure.centre.x());
        const Result<double> y = numberOf(parameters, "y", figure.centre.y());
        const Result<double> turn = numberOf(parameters, "turn", degrees(figure.turn));
        for (const auto *number : {&x, &y, &turn})
            if (!*number)
                return tl::unexpected(number->error());
        figure.centre = {*x, *y};
        figure.turn = radians(*turn);
        const Result<Contour> contour = contourOf(figure);
        return contour ? Result<Figure>(std::move(figure)) : tl::unexpected(contour.error());
    }

    Session &m_session;
    Interaction &m_interaction;
};

} // namespace

void registerFigureCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const FigureCommands commands(session, interaction);
    const auto drawsShapes = inHand(interaction, "section.addShape");
    for (const FigureKind &kind : figureKinds()) {
        std::string name = kind.key;
        name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
        registry.add("section.add" + name,
                     {[commands, &kind](const CommandParameters &parameters, double time) {
                          return commands.add(kind, parameters, time);
                      },
                      {},
                      // While the tool draws shapes these say which one.
                      [drawsShapes, &interaction, &kind]() -> std::optional<bool> {
                          if (!*drawsShapes())
                              return {};
                          return interaction.settings().figure == kind.key;
                      }});
    }
    registry.add("section.addShape", {[commands](const CommandParameters &parameters, double time) {
                                          return commands.draw(parameters, time);
                                      },
                                      {},
                                      drawsShapes});
    registry.add("section.figure",
                 {[commands](const CommandParameters &parameters, double time) {
                      return commands.change(parameters, time);
                  },
                  needs([commands] { return commands.section() != nullptr; }, kNothingSelected)});
    registry.offer(kFigureWords);
}

} // namespace fff
