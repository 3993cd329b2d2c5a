#include "ui/properties/mark_group.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/mark_editing.h"
#include "core/interaction/mark_tool.h"
#include "core/model/origin.h"
#include "ui/bench/workbench.h"
#include "ui/properties/driven_field.h"

#include <QCoreApplication>
#include <QPlainTextEdit>

namespace fff::ui {

namespace {

struct MarkGroupTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::MarkGroup)
};

constexpr LengthEdit::Range kPlace{-kMaxCoordinate, kMaxCoordinate, 0.5, 1, 3};
constexpr LengthEdit::Range kHeight{0.5, 1000.0, 0.5, 1, 3};
constexpr NumberEdit::Range kTurn{-360.0, 360.0, 1.0, 0, 2};
constexpr int kWordLines = 2;

QString idOf(std::size_t index, const char *key)
{
    return QStringLiteral("mark%1.%2").arg(index).arg(QLatin1String(key));
}

} // namespace

MarkGroup::MarkGroup(Workbench &bench, QWidget *parent)
    : PropertyGroup(MarkGroupTexts::tr("Marks"), parent), m_bench(bench), m_rows(*this)
{
}

const Section *MarkGroup::section() const
{
    const std::vector<SectionRef> &selected = m_bench.interaction().selection();
    const Model &model = m_bench.session().model();
    const std::optional<Origin> origin =
        selected.size() == 1 ? originOf(model, selected.front()) : std::nullopt;
    return origin ? origin->section : nullptr;
}

const Mark *MarkGroup::mark(std::size_t index) const
{
    const Section *of = section();
    return of && index < of->marks.size() ? of->marks[index].get() : nullptr;
}

void MarkGroup::change(std::size_t index, const std::function<void(Lettering &)> &change)
{
    const Mark *now = mark(index);
    if (!now || !now->lettering)
        return;
    Lettering next = *now->lettering;
    change(next);
    if (!(next == *now->lettering))
        m_bench.editSections(letteringChanged(
            m_bench.session().committed(), m_bench.interaction().selection().front(), index, next));
}

void MarkGroup::run(const char *command, std::size_t index) const
{
    m_bench.run(QLatin1String(command), {{"mark", std::to_string(index)}});
}

void MarkGroup::addWords(std::size_t index)
{
    auto *words = new QPlainTextEdit(this);
    words->setTabChangesFocus(true);
    words->setLineWrapMode(QPlainTextEdit::NoWrap);
    words->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    words->setFixedHeight(kWordLines * words->fontMetrics().lineSpacing() +
                          2 * static_cast<int>(words->document()->documentMargin()) +
                          2 * words->frameWidth());
    connect(words, &QPlainTextEdit::textChanged, this, [this, index, words] {
        const std::string text = words->toPlainText().toStdString();
        // Nothing is no mark: it is deleted by its button.
        if (!words->toPlainText().trimmed().isEmpty())
            change(index, [&text](Lettering &lettering) { lettering.text = text; });
    });
    const QString id = idOf(index, "words");
    m_rows.add(new EditorRow(
        MarkGroupTexts::tr("Words"), id.toLatin1().constData(), words,
        [this, index, words] {
            const Mark *now = mark(index);
            const QString text =
                now && now->lettering ? QString::fromStdString(now->lettering->text) : QString();
            if (words->hasFocus() || words->toPlainText() == text)
                return;
            const QSignalBlocker quiet(words);
            words->setPlainText(text);
        },
        this));
    m_words = words;
}

Followed MarkGroup::followedOf(std::size_t index, const char *field) const
{
    return followedAt(m_bench, selectedSectionPlace(m_bench, DrivenPlace::Of::Lettering, field,
                                                    static_cast<int>(index)));
}

void MarkGroup::addNumber(std::size_t index, const QString &name, const char *key,
                          const LengthEdit::Range &range, double (*read)(const Lettering &),
                          void (*write)(Lettering &, double))
{
    const QString id = idOf(index, key);
    auto *row = new LengthRow(
        name, id.toLatin1().constData(), range,
        [this, index, read]() -> std::optional<double> {
            const Mark *now = mark(index);
            return now && now->lettering ? std::optional(read(*now->lettering)) : std::nullopt;
        },
        [this, index, write](double value) {
            change(index, [value, write](Lettering &lettering) { write(lettering, value); });
        },
        this);
    row->setFollowed(followedOf(index, key));
    m_rows.add(row);
}

void MarkGroup::addTurn(std::size_t index)
{
    auto *edit = new NumberEdit(kTurn, MarkGroupTexts::tr("°"), this);
    connect(edit, &NumberEdit::numberEdited, this, [this, index](double value) {
        change(index, [value](Lettering &lettering) { lettering.turn = radians(value); });
    });
    edit->setFollowed(followedOf(index, "turn"));
    const QString id = idOf(index, "turn");
    m_rows.add(new EditorRow(
        MarkGroupTexts::tr("Turned by"), id.toLatin1().constData(), edit,
        [this, edit, index] {
            const Mark *now = mark(index);
            edit->setNumber(now && now->lettering ? std::optional(degrees(now->lettering->turn))
                                                  : std::nullopt);
        },
        this));
}

void MarkGroup::addMark(std::size_t index, const Mark &drawn)
{
    const QString id = idOf(index, "kind");
    auto *kind = new ChoiceRow(
        //: %1 is a number
        MarkGroupTexts::tr("Mark %1").arg(index + 1), id.toLatin1().constData(),
        [this, index] {
            const Mark *now = mark(index);
            Choices choices;
            choices.all = {{MarkGroupTexts::tr("Engraved"), QColor()},
                           {MarkGroupTexts::tr("Scored"), QColor()}};
            choices.current = now && now->kind == Mark::Kind::Scored ? 1 : 0;
            return choices;
        },
        [this, index](int chosen) {
            m_bench.run(
                QStringLiteral("mark.change"),
                {{"mark", std::to_string(index)}, {"as", chosen == 1 ? "scored" : "engraved"}});
        },
        this);
    const QString button = idOf(index, "delete");
    kind->addButton(QStringLiteral("trash"), button.toLatin1().constData(),
                    MarkGroupTexts::tr("Delete this mark"),
                    [this, index] { run("mark.delete", index); });
    m_rows.add(kind);
    m_words = nullptr;
    if (!drawn.lettering)
        return;
    addWords(index);
    addNumber(
        index, MarkGroupTexts::tr("Letter height"), "height", kHeight,
        [](const Lettering &l) { return l.height; },
        [](Lettering &l, double value) { l.height = value; });
    addNumber(
        index, MarkGroupTexts::tr("X"), "x", kPlace, [](const Lettering &l) { return l.at.x(); },
        [](Lettering &l, double value) { l.at.x() = value; });
    addNumber(
        index, MarkGroupTexts::tr("Y"), "y", kPlace, [](const Lettering &l) { return l.at.y(); },
        [](Lettering &l, double value) { l.at.y() = value; });
    addTurn(index);
}

/// The rows are others only where the marks are of other kinds.
void MarkGroup::rebuild(const Section &of)
{
    QString built = QStringLiteral("%1:").arg(of.id.value);
    for (const MarkPointer &mark : of.marks)
        built += mark->lettering ? QStringLiteral("w") : QStringLiteral("l");
    if (!m_rows.become(built))
        return;
    for (std::size_t i = 0; i < of.marks.size(); ++i)
        addMark(i, *of.marks[i]);
    // Words that were set with a click are written next.
    const Tool *tool = m_bench.interaction().tool();
    const bool isNew = of.id == m_of && of.marks.size() == m_count + 1 && m_words && tool &&
                       tool->command() == MarkTool::kCommand;
    if (isNew) {
        m_rows.refresh();
        QMetaObject::invokeMethod(
            m_words,
            [words = m_words] {
                words->setFocus(Qt::OtherFocusReason);
                words->selectAll();
            },
            Qt::QueuedConnection);
    }
}

void MarkGroup::refresh()
{
    const Section *of = section();
    setVisible(of && !of->marks.empty());
    if (of) {
        rebuild(*of);
        m_rows.refresh();
    }
    m_of = of ? of->id : SectionId();
    m_count = of ? of->marks.size() : 0;
}

} // namespace fff::ui
