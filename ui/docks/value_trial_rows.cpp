#include "ui/docks/value_trial_rows.h"

#include "core/interaction/value_editing.h"
#include "core/interaction/value_trial_editing.h"
#include "core/io/listing.h"
#include "core/operations/driven.h"
#include "core/session/message_text.h"
#include "core/session/scheduler.h"
#include "core/values/number_text.h"
#include "ui/base/theme.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/link_row.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr std::size_t kMostPlaces = 5; // that are listed
constexpr int kBetweenTrialRows = 2;   // px

QString namesOfOtherRanges(const Document &before, const Document &now)
{
    QStringList names;
    for (const ValuePointer &known : now.values.list) {
        const Value *was = before.values.find(known->value.id);
        if (was && (was->range != known->value.range || was->choices != known->value.choices))
            names += QString::fromStdString(known->value.name);
    }
    return separated(names);
}

} // namespace

ValueTrialRows::ValueTrialRows(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    setObjectName(QStringLiteral("valueTrials"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kBetweenTrialRows);
    const auto addLabel = [&](const char *name) {
        auto *label = new QLabel(this);
        label->setObjectName(QLatin1String(name));
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        column->addWidget(label);
        return label;
    };
    m_said = addLabel("valueTrialSaid");
    for (std::size_t i = 0; i < kMostPlaces; ++i) {
        auto *row = new LinkRow(this);
        row->setObjectName(QStringLiteral("valueTrialPlace"));
        connect(row, &LinkRow::clicked, this, [this, i] { goTo(i); });
        column->addWidget(row);
        m_places.push_back(row);
    }
    m_others = addLabel("valueTrialOthers");
    m_others->setForegroundRole(QPalette::PlaceholderText);
    m_links = new LinkRow(this);
    m_links->setObjectName(QStringLiteral("valueTrialLinks"));
    connect(m_links, &LinkRow::clicked, this, [this](int index) { act(index); });
    column->addWidget(m_links);
    connect(&m_job, &ValueTrialJob::changed, this, &ValueTrialRows::refresh);
    connect(&bench.session(), &Session::committedChanged, this, &ValueTrialRows::follow);
    connect(&bench.session(), &Session::replaced, &m_job, &ValueTrialJob::drop);
    refresh();
}

void ValueTrialRows::setOffered(bool isOffered)
{
    m_isOffered = isOffered;
    refresh();
}

/// What was found is of the ranges as they were. Places in them are as good as the one where it
/// began, also there and back by Undo.
void ValueTrialRows::follow()
{
    const Document &now = m_bench.session().committed().document;
    if (std::none_of(m_sameRanges.begin(), m_sameRanges.end(),
                     [&](const Document &one) { return one.isSame(now); }))
        m_job.drop();
    m_refusal.clear();
    m_done.clear();
    refresh();
}

void ValueTrialRows::act(int index)
{
    const Model &model = m_bench.session().committed();
    switch (m_does[static_cast<std::size_t>(index)]) {
    case Does::Try:
        m_refusal.clear();
        m_done.clear();
        m_sameRanges = {model.document};
        m_job.start(model, m_bench.session().scheduler().rules());
        break;
    case Does::Stop:
        m_job.drop();
        break;
    case Does::Narrow:
        narrow();
        break;
    }
}

void ValueTrialRows::narrow()
{
    const Document before = m_bench.session().committed().document;
    carryOut(rangesNarrowed(m_bench.session().committed(), *m_job.result()));
    const QString names = namesOfOtherRanges(before, m_bench.session().committed().document);
    if (m_refusal.isEmpty() && !names.isEmpty())
        //: %1 are names of values: "width, boards"
        m_done = tr("The range is narrower now of: %1.").arg(names);
    refresh();
}

void ValueTrialRows::goTo(std::size_t row)
{
    const std::shared_ptr<const ValueTrials> trials = m_job.result();
    if (!trials || row >= m_worst.size())
        return;
    const Document &now = m_bench.session().committed().document;
    SectionEdit edit = valuesAt(now, *trials, trials->places[m_worst[row]].at);
    if (edit) // it is committed as it agrees with its values
        m_sameRanges.push_back(driven(edit->document).document);
    if (edit)
        edit->document = m_sameRanges.back();
    carryOut(std::move(edit));
}

void ValueTrialRows::carryOut(SectionEdit edit)
{
    m_refusal = tryEdit(m_bench, std::move(edit));
    refresh();
}

QString ValueTrialRows::verdict() const
{
    const ValueTrials &trials = *m_job.result();
    const int count = static_cast<int>(trials.places.size());
    const auto failing = static_cast<int>(trials.failing());
    QString said = tr("All %n variant(s) that were tried are good.", nullptr, count);
    if (failing > 0) {
        QStringList faults;
        for (const auto &[title, times] : trials.faults())
            //: %1 is what is wrong, such as "Falls over", %2 in how many places it is
            faults += tr("%1 (%2)").arg(messageText(title, unitsInUse())).arg(times);
        //: %1 is a number, %2 a list such as "Falls over (5), Breaks (2)"
        said = tr("%1 of %n variant(s) fail: %2.", nullptr, count)
                   .arg(failing)
                   .arg(separated(faults));
    }
    if (static_cast<double>(trials.corners) < trials.allCorners)
        said += u' ' + tr("Of %1 corners %2 were tried.")
                           .arg(trials.allCorners, 0, 'f', 0)
                           .arg(trials.corners);
    return said;
}

QString ValueTrialRows::placeText(std::size_t index) const
{
    const ValueTrials &trials = *m_job.result();
    const TriedPlace &place = trials.places[index];
    QStringList values;
    for (const auto &[name, worth] : worthsAt(trials.values, place.at))
        //: %1 is the name of a value, %2 what it is: "width 400 mm"
        values += tr("%1 %2").arg(QString::fromStdString(name),
                                  argumentText(argumentOf(worth), unitsInUse()));
    QStringList faults;
    for (const Message &fault : place.faults)
        faults += messageText(fault, unitsInUse());
    if (!place.wrong.isEmpty())
        faults += messageText(place.wrong, unitsInUse());
    //: %1 is "width 400 mm, boards 6", %2 what is wrong there
    return tr("%1: %2").arg(separated(values), separated(faults));
}

void ValueTrialRows::showPlaces()
{
    m_worst.clear();
    QStringList texts;
    // Places between the steps that are shown read alike: one of them is enough.
    for (const std::size_t place :
         m_job.result() ? m_job.result()->worst() : std::vector<std::size_t>())
        if (const QString text = placeText(place); !texts.contains(text)) {
            m_worst.push_back(place);
            texts += text;
        }
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const bool isThere = i < m_worst.size();
        m_places[i]->setVisible(isThere);
        if (isThere)
            m_places[i]->setTexts({texts[static_cast<qsizetype>(i)]});
    }
    const int others = static_cast<int>(m_worst.size()) - static_cast<int>(m_places.size());
    m_others->setVisible(others > 0);
    m_others->setText(tr("and %n other(s)", nullptr, std::max(others, 0)));
}

void ValueTrialRows::refresh()
{
    const std::shared_ptr<const ValueTrials> trials = m_job.result();
    const bool isWanted =
        m_isOffered && (m_job.isRunning() || !rangedValues(m_bench.session().committed()).empty());
    setVisible(isWanted);
    if (!isWanted)
        return;
    const bool fails = trials && trials->failing() > 0;
    QString said = m_refusal.isEmpty() ? m_done : m_refusal;
    if (said.isEmpty() && m_job.isRunning())
        said = tr("Trying the ranges… %1 %").arg(static_cast<int>(100.0 * m_job.progress()));
    else if (said.isEmpty() && trials)
        said = verdict();
    m_said->setText(said);
    m_said->setVisible(!said.isEmpty());
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, fails || !m_refusal.isEmpty() ? theme().problem
                                           : trials                      ? theme().good
                                                                         : theme().muted);
    m_said->setPalette(colours);
    showPlaces();
    QStringList links;
    m_does = {m_job.isRunning() ? Does::Stop : Does::Try};
    links += m_job.isRunning() ? tr("Stop") : trials ? tr("Try again") : tr("Try all ranges");
    if (fails) {
        m_does.push_back(Does::Narrow);
        links += tr("Narrow the ranges");
    }
    m_links->setTexts(links);
    m_links->setToolTip(
        m_job.isRunning() || trials
            ? QString()
            : tr("Says where in the ranges of the shown values the model cannot be assembled, "
                 "breaks, falls over or does not fit."));
}

} // namespace fff::ui
