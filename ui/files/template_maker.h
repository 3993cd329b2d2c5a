// What is made of a template at once, beside the window: sections that are suggested, and flat
// sheets. One step each.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/analysis/suggesting/suggestion.h"
#include "core/interaction/section_edit.h"
#include "core/interaction/template_drawing.h"

#include <functional>
#include <optional>

class QWidget;

namespace fff::ui {

class Workbench;

class TemplateMaker : public QObject
{
    Q_OBJECT
public:
    TemplateMaker(QWidget &window, Workbench &bench);

    // Each does nothing where it is given up.

    /// As the command, by the planes of a few that can be made.
    void slice(TemplateId of);
    /// What was suggested before goes, as far as nothing else was done since.
    void suggest(TemplateId of, int count);
    /// To the sections that are there.
    void suggestOneMore(TemplateId of);
    /// Others instead of the last.
    void suggestAnother();
    /// Whether what was suggested last is still the newest step.
    bool hasSuggestion() const { return isNewest() && m_last->options; }
    /// What was made of it just before goes.
    void makeFacets(TemplateId of, int faces);
    void makeNet(TemplateId of, int faces);
    /// What is known of it already is not traced again.
    void trace(const WantedTrace &wanted);

Q_SIGNALS:
    void failed(const QString &text);
    /// What came of it.
    void said(const QString &sentence);

private:
    /// A model, and how many steps of the history led to it.
    struct State
    {
        Model model;
        int step = 0;
    };
    struct Last
    {
        TemplateId of;
        std::optional<SuggestionOptions> options; // none: facets
        State before, first;                      // of the first of several that follow each other
        int step = 0;                             // of the history, behind it
        Document document;
    };
    void carryOut(const SectionEdit &edit);
    using Work = std::function<Result<SectionEdit>(const Model &before, const LongWork &work)>;

    bool isNewest() const;
    /// From which to start where what was made of this template just before is to go.
    State start(TemplateId of) const;
    State now() const;
    void suggest(TemplateId of, const SuggestionOptions &options, State before, State first);
    /// Commits what comes of it after `last.before`: what came behind that goes.
    void make(const QString &text, Last last, Work work);

    QWidget &m_window;
    Workbench &m_bench;
    std::optional<Last> m_last;
};

} // namespace fff::ui
