#include "ui/docks/joint_page.h"

#include "core/assembly/joint_editing.h"
#include "core/base/units.h"
#include "core/io/full_stop.h"
#include "ui/base/icon.h"
#include "ui/base/lengths.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"
#include "ui/docks/problem_box.h"
#include "ui/properties/joint_words.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/slider_field.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fff::ui {

namespace {

constexpr double kLeastPercent = 100.0 * kLeastShare, kMostPercent = 100.0 - kLeastPercent;
constexpr int kFieldWidth = 76; // px
/// Digits that percents are worth: the rest is rounding of the share.
constexpr double kPercentDigits = 1e6;

} // namespace

JointPage::JointPage(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    m_problem = new ProblemBox("jointProblem", this);
    connect(m_problem, &ProblemBox::linkActivated, this, [this](const QString &target) {
        if (!m_joint)
            return;
        const bool isA = target == QLatin1String("a");
        m_bench.editJoint(trimTo(m_bench.session().committed(), isA ? m_joint->a : m_joint->b,
                                 isA ? m_joint->b : m_joint->a));
    });
    // One group after the other: the Tab key goes in the order that they are made in.
    auto *joint = new PropertyGroup(tr("Joint"), this);
    addChoices(joint);
    m_slits = new PropertyGroup(tr("Slits"), this);
    addMeasures(m_slits);

    m_reset = new QPushButton(tr("Restore automatic settings"), this);
    m_reset->setObjectName(QStringLiteral("jointReset"));
    m_reset->setIcon(themedIcon(QStringLiteral("joint_reset")));
    m_reset->setAutoDefault(false);
    connect(m_reset, &QPushButton::clicked, this,
            [this] { m_bench.run(QStringLiteral("joint.reset")); });

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_problem);
    column->addWidget(joint);
    column->addWidget(m_slits);
    column->addWidget(m_reset, 0, Qt::AlignLeft);
    setFocusProxy(m_links);
}

void JointPage::addChoices(PropertyGroup *group)
{
    m_links = new QLabel;
    m_links->setTextFormat(Qt::RichText);
    m_links->setWordWrap(true);
    m_links->setFocusPolicy(Qt::StrongFocus);
    m_links->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    connect(m_links, &QLabel::linkActivated, this, [this](const QString &target) {
        if (!m_joint)
            return;
        const bool isA = target == QLatin1String("a");
        Q_EMIT sectionWanted(SectionRef(isA ? m_joint->a : m_joint->b),
                             SectionRef(isA ? m_joint->b : m_joint->a));
    });
    connect(m_links, &QLabel::linkHovered, this, &JointPage::outline);
    m_links->installEventFilter(this);
    group->add(new EditorRow(tr("Sections"), "jointSections", m_links, {}, group));

    // Another kind of joint is one more in JointState::kKinds.
    m_kind = new ChoiceRow(
        tr("Kind"), "jointKind",
        [this] {
            Choices choices;
            for (const JointKind kind : JointState::kKinds) {
                if (m_state && kind == m_state->kind)
                    choices.current = static_cast<int>(choices.all.size());
                choices.all.push_back(
                    {jointKindName(kind), QColor(),
                     m_state ? jointObstacleText(m_state->obstacleTo(kind)) : QString()});
            }
            return choices;
        },
        [this](int index) {
            if (m_joint)
                m_bench.editJoint(setKind(m_bench.session().committed(), *m_joint,
                                          JointState::kKinds[static_cast<std::size_t>(index)]));
        },
        group);
    m_opens = new ChoiceRow(
        tr("Opens"), "jointOpens",
        [this] {
            Choices choices;
            const auto openings = m_state ? openingsOfB(*m_state) : std::nullopt;
            if (!openings)
                return choices;
            const QString whyNot =
                m_state->canFlip ? QString() : jointObstacleText(JointObstacle::EndsOnHole);
            choices.current = static_cast<int>(openings->current);
            for (std::size_t i = 0; i < openings->ways.size(); ++i)
                choices.all.push_back({directionName(openings->ways[i]), QColor(),
                                       i == openings->current ? QString() : whyNot});
            return choices;
        },
        [this](int index) { chooseSide(index); }, group);
    m_opens->addButton(QStringLiteral("joint_flip"), "jointFlip", tr("Flip the slits"),
                       [this] { m_bench.run(QStringLiteral("joint.flip")); });
    for (ChoiceRow *row : {m_kind, m_opens})
        group->add(row);
    m_shareRows = new QWidget(group);
    auto *shares = new QVBoxLayout(m_shareRows);
    shares->setContentsMargins(0, 0, 0, 0);
    shares->setSpacing(0);
    group->add(m_shareRows);
    addShareRow();
}

/// target: of the link under the cursor, empty when there is none.
void JointPage::outline(const QString &target)
{
    const bool isOver = m_joint && !target.isEmpty();
    if (!isOver && !m_isOutlining)
        return; // what is outlined is not ours
    m_isOutlining = isOver;
    std::vector<SectionRef> outlined;
    if (isOver)
        outlined = {target == QLatin1String("a") ? m_joint->a : m_joint->b};
    m_bench.setOutlined(std::move(outlined));
}

bool JointPage::eventFilter(QObject *object, QEvent *event)
{
    // A label tells of the cursor only while it is over it.
    if (object == m_links && (event->type() == QEvent::Leave || event->type() == QEvent::Hide))
        outline({});
    return QWidget::eventFilter(object, event);
}

void JointPage::addMeasures(PropertyGroup *group)
{
    const auto add = [this, group](const QString &name, const char *objectName,
                                   std::function<QString()> read) {
        auto *row = new TextRow(
            name, objectName, [this, read] { return m_state ? read() : QString(u'–'); }, group);
        group->add(row);
        return row;
    };
    m_slitsOfA =
        add(tr("Slit"), "jointSlitsA", [this] { return slitsText(measuresOfA(*m_state)); });
    m_slitsOfB =
        add(tr("Slit"), "jointSlitsB", [this] { return slitsText(measuresOfB(*m_state)); });
    m_angle = add(tr("Angle"), "jointAngle", [this] {
        return tr("%1°").arg(numberText(degrees(m_state->crossing.angle), 0, 1, locale()));
    });
}

void JointPage::addShareRow()
{
    const int overlap = static_cast<int>(m_shares.size());
    auto *number = new NumberEdit({kLeastPercent, kMostPercent, 1.0, 0, 1}, tr("%"));
    number->setMinimumWidth(kFieldWidth);
    auto *field = new SliderField({kLeastPercent, kMostPercent, 1.0, 5}, number, m_shareRows);
    const QByteArray name = "jointShare" + QByteArray::number(overlap + 1);
    auto *row = new EditorRow(tr("Meeting point"), name.constData(), field, {}, m_shareRows);
    m_shareRows->layout()->addWidget(row);
    const auto edited = [this, overlap](double percent) {
        return moveMeetingPoint(m_bench.session().committed(), *m_joint, overlap, shareOf(percent));
    };
    connect(field, &SliderField::dragged, this, [this, edited](double percent) {
        if (!m_joint)
            return;
        if (JointEdit edit = edited(percent))
            m_bench.session().preview(std::move(edit->document));
    });
    connect(field, &SliderField::settled, this, [this, edited](double percent) {
        if (!m_joint)
            return;
        JointEdit edit = edited(percent);
        if (!edit)
            m_bench.session().cancelPreview();
        m_bench.editJoint(std::move(edit));
        refresh(); // a refused value goes back to what it was
    });
    connect(field, &SliderField::cancelled, this, [this] { m_bench.session().cancelPreview(); });
    dress(row); // the window may be dressed by then
    if (!m_shares.empty())
        field->comeAfter(*m_shares.back().field);
    m_shares.push_back({field, row});
}

void JointPage::chooseSide(int index)
{
    const auto openings = m_joint && m_state ? openingsOfB(*m_state) : std::nullopt;
    if (openings && static_cast<std::size_t>(index) != openings->current)
        m_bench.editJoint(flipSlits(m_bench.session().committed(), *m_joint));
}

QString JointPage::name(int section) const
{
    return QString::fromStdString(
        m_bench.session().model().section(static_cast<std::size_t>(section))->name);
}

QString JointPage::slitText(const SlitMeasure &slit) const
{
    const QString width = lengthText(slit.width, 2, 2, locale());
    const QString length = lengthText(slit.length, 1, 1, locale());
    switch (slit.form) {
    case SlitMeasure::Form::Tab:
        return tr("tab, %1 wide").arg(lengthText(slit.width, 1, 1, locale()));
    case SlitMeasure::Form::Closed:
        return tr("closed, %1 long, %2 wide").arg(length, width);
    case SlitMeasure::Form::Open:
        break;
    }
    return tr("%1 deep, %2 wide").arg(length, width);
}

/// One line for those that are alike and follow each other.
QString JointPage::slitsText(const std::vector<SlitMeasure> &slits) const
{
    std::vector<std::pair<QString, int>> alike;
    for (const SlitMeasure &slit : slits) {
        const QString text = slitText(slit);
        if (alike.empty() || alike.back().first != text)
            alike.emplace_back(text, 0);
        ++alike.back().second;
    }
    if (alike.empty())
        return tr("none");
    QStringList lines;
    for (const auto &[text, count] : alike)
        lines += count == 1 ? text : tr("%1 × %2").arg(locale().toString(count), text);
    return lines.join(QLatin1Char('\n'));
}

/// Why they collide, unless it is wanted so, and what helps.
QString JointPage::problemText(const QString &a, const QString &b) const
{
    const QString why = jointObstacleText(m_state->whyNoJoint());
    QStringList text{tr("%1 and %2 overlap.").arg(a.toHtmlEscaped(), b.toHtmlEscaped())};
    if (!why.isEmpty())
        text += withFullStop(why);
    QStringList links;
    for (const auto &[section, target] : {std::pair(&m_joint->a, "a"), {&m_joint->b, "b"}}) {
        if (section->drawn.isValid())
            links += linkTo(tr("Trim %1").arg(*target == 'a' ? a : b), QLatin1String(target));
    }
    return text.join(QLatin1Char(' ')) +
           (links.isEmpty() ? QString()
                            : QStringLiteral("<br>") + links.join(QStringLiteral(" · ")));
}

void JointPage::follow()
{
    const std::optional<JointRef> &selected = m_bench.interaction().selectedJoint();
    if (m_joint == selected)
        return;
    // An edit that this commits may come back here, and bring more rows.
    for (std::size_t i = 0; i < m_shares.size(); ++i)
        m_shares[i].field->settle();
    m_joint = selected;
    m_state.reset();
}

void JointPage::refreshShares()
{
    const std::size_t count = m_state->shares.size();
    while (m_shares.size() < count)
        addShareRow();
    for (std::size_t i = 0; i < m_shares.size(); ++i) {
        const auto [field, row] = m_shares[i];
        const bool isShown =
            m_state && i < m_state->shares.size() && m_state->shares[i].has_value();
        row->setVisible(isShown); // one that loses the focus settles, which comes back here, too
        if (!isShown)
            continue;
        const double percent =
            std::round(100.0 * (1.0 - *m_state->shares[i]) * kPercentDigits) / kPercentDigits;
        field->setNumber(percent);
        if (count > 1)
            row->setName(tr("Meeting point %1"), locale().toString(static_cast<qulonglong>(i + 1)));
        else
            row->setName(tr("Meeting point"));
        const QString tip = tr("The slit of %1 takes this share of the depth, that of %2 the rest")
                                .arg(name(m_state->b), name(m_state->a));
        row->setToolTip(tip);
        const bool isSet = m_state->isShareWanted[i];
        row->setMarked(isSet, isSet ? tr("Set by hand; automatic is 50\u202f%. %1").arg(tip) : tip);
    }
}

void JointPage::refresh()
{
    follow();
    if (!m_joint)
        return;
    m_state = jointState(m_bench.session().model(), *m_joint);
    setEnabled(m_state.has_value());
    if (!m_state)
        return;
    const QString a = name(m_state->a), b = name(m_state->b);
    m_links->setText(linkTo(a, QStringLiteral("a")) + QStringLiteral(" · ") +
                     linkTo(b, QStringLiteral("b")));
    m_links->setAccessibleName(tr("Sections: %1 and %2").arg(a, b));
    static_cast<void>(m_links->sizeHint()); // reads the text: the Tab key may come before a paint

    const JointOverride &wanted = m_state->wanted;
    m_kind->refresh();
    m_kind->setMarked(wanted.kind.has_value(),
                      wanted.kind ? tr("Set by hand; the automatic setting can be restored")
                                  : QString());
    m_opens->setVisible(m_state->sign != 0);
    m_opens->setName(tr("%1 opens"), b);
    m_opens->refresh();
    m_opens->setMarked(
        wanted.opens.has_value(),
        wanted.opens
            ? tr("Set by hand; the automatic setting can be restored")
            : tr("The side that the slit of %1 opens to; that of %2 opens to the other").arg(b, a));
    refreshShares();
    if (!m_state)
        return;
    m_slitsOfA->setName(tr("In %1"), a);
    m_slitsOfB->setName(tr("In %1"), b);
    for (TextRow *row : {m_slitsOfA, m_slitsOfB, m_angle})
        row->refresh();

    const bool collides = m_state->kind == JointKind::None;
    if (collides)
        m_problem->tell(Severity::Warning, problemText(a, b));
    else
        m_problem->hide();
    const bool isSet = !wanted.isEmpty();
    if (!isSet && m_reset->hasFocus())
        m_kind->setFocus(); // Qt would give it to another dock
    m_reset->setEnabled(isSet);
    m_reset->setToolTip(isSet
                            ? tr("Let the program choose kind, direction and meeting points again")
                            : tr("Nothing of this joint is set by hand"));
}

} // namespace fff::ui
