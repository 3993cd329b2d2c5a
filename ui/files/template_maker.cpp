#include "ui/files/template_maker.h"

#include "core/analysis/suggesting/first_slices.h"
#include "core/io/error_text.h"
#include "core/session/flat_template_commands.h"
#include "core/session/session.h"
#include "core/session/template_making.h"
#include "ui/bench/workbench.h"
#include "ui/files/progress.h"

#include <QUndoStack>
#include <QWidget>

namespace fff::ui {

TemplateMaker::TemplateMaker(QWidget &window, Workbench &bench)
    : QObject(&window), m_window(window), m_bench(bench)
{
}

bool TemplateMaker::isNewest() const
{
    const Session &session = m_bench.session();
    return m_last && session.history()->index() == m_last->step &&
           session.committed().document.isSame(m_last->document);
}

TemplateMaker::State TemplateMaker::now() const
{
    const Session &session = m_bench.session();
    return {session.committed(), session.history()->index()};
}

TemplateMaker::State TemplateMaker::start(TemplateId of) const
{
    return isNewest() && m_last->of == of ? m_last->first : now();
}

void TemplateMaker::slice(TemplateId of)
{
    const Model model = m_bench.session().committed();
    const Template *one = model.document.find(of);
    if (!one)
        return;
    std::stop_source stop;
    const auto found = inBackground<Result<FirstSlices>>(
        m_window, tr("Looking for planes…"), MayCancel::Yes, [model, of, token = stop.get_token()] {
            return firstSlices(model, of, {token, {}});
        });
    if (!found) {
        stop.request_stop();
        return;
    }
    if (!m_bench.session().committed().document.isSame(model.document))
        return;
    const FirstSlices usual, planes = found->value_or(usual);
    CommandParameters said{{"template", one->name}};
    if (planes.direction != usual.direction)
        said["direction"] = planes.direction;
    if (planes.count != usual.count)
        said["count"] = std::to_string(planes.count);
    if (planes.shift != usual.shift)
        said["shift"] = std::to_string(planes.shift);
    m_bench.run(QStringLiteral("operation.slices"), said);
}

void TemplateMaker::suggest(TemplateId of, int count)
{
    SuggestionOptions options{count};
    if (hasSuggestion() && m_last->of == of)
        options.seed = m_last->options->seed;
    suggest(of, options, start(of), start(of));
}

void TemplateMaker::suggestOneMore(TemplateId of)
{
    suggest(of, {1}, now(), start(of));
}

void TemplateMaker::suggestAnother()
{
    if (!hasSuggestion())
        return;
    ++m_last->options->seed; // the one after it is tried next where this one comes to nothing
    suggest(m_last->of, *m_last->options, m_last->before, m_last->first);
}

void TemplateMaker::suggest(TemplateId of, const SuggestionOptions &options, State before,
                            State first)
{
    make(tr("Looking for sections…"), {of, options, std::move(before), std::move(first), 0, {}},
         [of, options](const Model &model, const LongWork &work) {
             return suggestedEdit(model, of, options, work);
         });
}

void TemplateMaker::makeFacets(TemplateId of, int faces)
{
    make(tr("Making facets…"), {of, {}, start(of), start(of), 0, {}},
         [of, faces](const Model &model, const LongWork &work) {
             return facetEdit(model.document, of, static_cast<std::size_t>(faces), work);
         });
}

void TemplateMaker::makeNet(TemplateId of, int faces)
{
    make(tr("Unfolding…"), {of, {}, start(of), start(of), 0, {}},
         [of, faces](const Model &model, const LongWork &work) {
             return netEdit(model.document, of, static_cast<std::size_t>(faces), work);
         });
}

void TemplateMaker::trace(const WantedTrace &wanted)
{
    const Model model = m_bench.session().committed();
    const Template *one = model.document.find(wanted.of);
    if (!one)
        return;
    Result<SectionRef> section;
    if (wanted.as != DrawingAs::Sections)
        section = sectionToDrawOn(model, one->on, m_bench.interaction().sectionsInFocus());
    if (!section) {
        Q_EMIT failed(
            wanted.as == DrawingAs::Holes
                ? tr("Select the section to cut holes in first, or place the drawing on it.")
                : tr("Select the section to engrave first, or place the drawing on it."));
        return;
    }
    m_bench.layDownTool();
    const InteractionSettings &settings = m_bench.interaction().settings();
    const DrawingRules rules{settings.cutsAtGround, settings.naming, {}};
    std::stop_source stop;
    const auto made = inBackground<Result<SectionEdit>>(
        m_window, tr("Tracing %1…").arg(QString::fromStdString(one->name)), MayCancel::Yes,
        [model, wanted, rules, ref = *section, token = stop.get_token()]() -> Result<SectionEdit> {
            const Result<Drawing> drawing =
                drawingOf(model, *model.document.find(wanted.of), wanted, {token, {}});
            if (!drawing)
                return tl::unexpected(drawing.error());
            return madeOfDrawing(model, *drawing, wanted.as, ref, rules);
        });
    if (!made)
        stop.request_stop();
    else if (!*made)
        Q_EMIT failed(io::errorText(made->error()));
    else if (m_bench.session().committed().document.isSame(model.document))
        carryOut(**made);
}

/// And says what came of it, unless there is more to say than that.
void TemplateMaker::carryOut(const SectionEdit &edit)
{
    const std::size_t before = m_bench.session().committed().sectionCount();
    const bool isTold = !edit || edit->note;
    m_bench.editSections(edit);
    const std::size_t now = m_bench.session().committed().sectionCount();
    if (!isTold && now > before)
        Q_EMIT said(tr("Made %n section(s).", nullptr, static_cast<int>(now - before)));
}

void TemplateMaker::make(const QString &text, Last last, Work work)
{
    const Document before = m_bench.session().committed().document;
    std::stop_source stop;
    const auto made = inBackground<Result<SectionEdit>>(
        m_window, text, MayCancel::Yes,
        [work = std::move(work), model = last.before.model, token = stop.get_token()] {
            return work(model, {token, {}});
        });
    if (!made) {
        stop.request_stop();
        return;
    }
    if (!*made) {
        Q_EMIT failed(io::errorText(made->error()));
        return;
    }
    if (!m_bench.session().committed().document.isSame(before))
        return;
    if (const SectionEdit &edit = **made) {
        m_bench.session().history()->setIndex(last.before.step);
        last.step = last.before.step + 1;
        last.document = edit->document;
        m_last = std::move(last); // before the commit, after which everybody asks
    }
    m_bench.editSections(**made);
}

} // namespace fff::ui
