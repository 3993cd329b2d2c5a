// *Try all*: what becomes of the model over the ranges of its shown values. A click on a place goes
// there; what does not hold can be left out of the ranges.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/interaction/section_edit.h"
#include "ui/docks/value_trial_job.h"

#include <vector>

class QLabel;

namespace fff::ui {

class LinkRow;
class Workbench;

class ValueTrialRows : public QWidget
{
    Q_OBJECT
public:
    ValueTrialRows(Workbench &bench, QWidget *parent);

    /// As values and trials are now.
    void refresh();
    /// Not for whoever only adjusts.
    void setOffered(bool isOffered);

private:
    enum class Does { Try, Stop, Narrow };
    void follow();
    void act(int index);
    void goTo(std::size_t row);
    void carryOut(SectionEdit edit);
    void narrow();
    QString verdict() const;
    QString placeText(std::size_t index) const;
    void showPlaces();

    Workbench &m_bench;
    QLabel *m_said = nullptr;
    std::vector<LinkRow *> m_places;
    QLabel *m_others = nullptr;
    LinkRow *m_links = nullptr;
    std::vector<Does> m_does;           // of the links
    std::vector<std::size_t> m_worst;   // of the places, as they are listed
    std::vector<Document> m_sameRanges; // of which the trials are, too: their places
    QString m_refusal, m_done;          // what came of the last link
    bool m_isOffered = true;
    ValueTrialJob m_job; // last: its destructor waits
};

} // namespace fff::ui
