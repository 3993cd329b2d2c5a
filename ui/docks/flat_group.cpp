#include "ui/docks/flat_group.h"

#include "core/base/units.h"
#include "core/interaction/template_drawing.h"
#include "ui/bench/workbench.h"
#include "ui/docks/trace_preview.h"
#include "ui/properties/kept_number.h"

#include <QEvent>
#include <QGridLayout>
#include <QPushButton>
#include <QUndoStack>
#include <QVBoxLayout>

#include <array>
#include <cmath>
#include <tuple>

namespace fff::ui {

namespace {

constexpr int kFlatGap = 6; // px
constexpr double kAll = 100.0;
constexpr std::int64_t kSampled = 250'000; // px that are looked at for a threshold
constexpr std::array<const char *, 4> kPlanes{"ground", "front", "side", "section"};
/// Cosine, of a plane that is told by its name: within half a degree.
constexpr double kSameDirectionAs = 0.99996;
constexpr NumberEdit::Range kFlatTurn{-360.0, 360.0, 1.0, 0, 2};

} // namespace

FlatGroup::FlatGroup(Workbench &bench, std::function<const Template *()> chosen, QWidget *parent)
    : QWidget(parent), m_bench(bench), m_chosen(std::move(chosen)),
      m_preview(new TracePreview(bench, this))
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_trace = new PropertyGroup(tr("Trace"), this);
    m_place = new PropertyGroup(tr("Lies on"), this);
    addTrace();
    addPlace();
    column->addWidget(m_trace);
    column->addWidget(m_place);
    // Who draws over a picture by hand does not want its outlines in the way.
    m_trace->fold();
}

void FlatGroup::addPlace()
{
    addButtons(
        m_place,
        {{tr("Ground"), "ground", tr("Lay it on the ground")},
         {tr("Front"), "front", tr("Stand it up, to be seen from the front")},
         {tr("Side"), "side", tr("Stand it up, to be seen from the right")},
         {tr("Section"), "section", tr("Lay it on the selected section, with which it goes")}},
        [this](const char *plane) {
            if (const Template *one = m_chosen())
                m_bench.run(QStringLiteral("template.lay"),
                            {{"template", one->name}, {"plane", plane}});
            showPlane(); // also where it already lay there
        });
    for (const char *plane : kPlanes)
        m_place->findChild<QPushButton *>(QLatin1String("flat.") + QLatin1String(plane))
            ->setCheckable(true);
    m_turn = new NumberEdit(kFlatTurn, tr("°"));
    connect(m_turn, &NumberEdit::numberEdited, this, [this](double degrees) {
        if (const Template *one = m_chosen())
            m_bench.run(QStringLiteral("template.set"),
                        {{"template", one->name}, {"turn", std::to_string(degrees)}});
    });
    m_place->add(new EditorRow(tr("Turn"), "templateTurn", m_turn, {}, m_place));
    addButtons(m_place,
               {{tr("Flip"), "flip", tr("As seen from behind")},
                {tr("Align two"), "align",
                 tr("The last two pictures as front and side of the same thing: as high as each "
                    "other, and above the same place")}},
               [this](const char *what) {
                   const Template *one = m_chosen();
                   if (!one)
                       return;
                   if (*what == 'f')
                       m_bench.run(QStringLiteral("template.set"),
                                   {{"template", one->name},
                                    {"flipped", one->isFlipped ? "false" : "true"}});
                   else
                       m_bench.run(QStringLiteral("template.align"), {});
               });
}

void FlatGroup::addTrace()
{
    m_thresholdField = percent(m_trace, tr("Threshold"), "traceThreshold", &m_threshold,
                               tr("How dark it has to be to be traced"));
    percent(m_trace, tr("Smoothing"), "traceSmoothing", &m_smoothing,
            tr("How round corners become"));
    m_outlines = new TextRow(
        tr("Outlines"), "traceOutlines", [this] { return outlinesFound(); }, m_trace);
    m_trace->add(m_outlines);
    m_ofPictures.push_back(m_outlines);
    m_outlines->installEventFilter(this); // what is drawn in the view comes and goes with it
    connect(m_preview, &TracePreview::changed, this, [this] { m_outlines->refresh(); });
    addButtons(m_trace,
               {{tr("Make sections"), "sections", tr("Sections of its outlines, on its own plane")},
                {tr("Cut holes"), "holes",
                 tr("Holes in the section that it lies on, or that is selected")},
                {tr("Engrave"), "engraved",
                 tr("Lines on the section that it lies on, or that is selected")}},
               [this](const char *as) {
                   const Template *one = m_chosen();
                   if (!one)
                       return;
                   const auto kind = *as == 's'   ? DrawingAs::Sections
                                     : *as == 'h' ? DrawingAs::Holes
                                                  : DrawingAs::Engraved;
                   const PictureTrace with = trace(*one);
                   const int step = m_bench.session().history()->index();
                   Q_EMIT traceWanted({one->id, kind, with, m_preview->known(*one, with)});
                   // What it would make is made: it covers the points of that.
                   if (m_bench.session().history()->index() != step)
                       m_trace->fold();
               });
}

PictureTrace FlatGroup::trace(const Template &one) const
{
    PictureTrace trace;
    if (one.picture) {
        trace.threshold = m_threshold / kAll;
        trace.smoothing = m_smoothing / kAll;
    }
    return trace;
}

/// As long as the numbers are seen.
void FlatGroup::preview()
{
    const Template *one = m_chosen();
    if (one && one->picture && m_outlines->isVisible())
        m_preview->show(*one, trace(*one));
    else
        m_preview->hide();
    m_outlines->refresh();
}

QString FlatGroup::outlinesFound() const
{
    const Template *one = m_chosen();
    const TracedPicturePointer known =
        one && one->picture ? m_preview->known(*one, trace(*one)) : nullptr;
    if (!known)
        return QStringLiteral("…");
    const QString count = locale().toString(static_cast<qulonglong>(known->regions));
    //: %1 is a number of outlines
    return known->regions > kMostPlacedSections ? tr("%1: too many for sections").arg(count)
                                                : count;
}

bool FlatGroup::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_outlines && event->type() == QEvent::Show)
        preview();
    else if (watched == m_outlines && event->type() == QEvent::Hide)
        m_preview->hide(); // also while all of this goes
    return QWidget::eventFilter(watched, event);
}

SliderField *FlatGroup::percent(PropertyGroup *group, const QString &name, const char *id,
                                int *kept, const QString &tip)
{
    constexpr int kAllOfIt = 100;
    const KeptNumber number =
        addKeptNumber(*group, name, id, {0, kAllOfIt, kAllOfIt, QStringLiteral("%"), 2}, kept);
    number.row->setToolTip(tip);
    connect(number.field, &SliderField::dragged, this, &FlatGroup::preview);
    connect(number.field, &SliderField::settled, this, &FlatGroup::preview);
    m_ofPictures.push_back(number.row);
    return number.field;
}

void FlatGroup::addButtons(PropertyGroup *group,
                           const std::vector<std::tuple<QString, const char *, QString>> &buttons,
                           const std::function<void(const char *)> &act)
{
    auto *all = new QWidget(group);
    constexpr int kColumns = 2; // more are wider than the dock
    auto *grid = new QGridLayout(all);
    grid->setContentsMargins(0, kFlatGap, 0, kFlatGap);
    grid->setSpacing(kFlatGap);
    int place = 0;
    for (const auto &[text, id, tip] : buttons) {
        auto *made = new QPushButton(text, all);
        made->setObjectName(QLatin1String("flat.") + QLatin1String(id));
        made->setToolTip(tip);
        made->setAutoDefault(false);
        connect(made, &QPushButton::clicked, this, [act, key = id] { act(key); });
        grid->addWidget(made, place / kColumns, place % kColumns);
        ++place;
    }
    group->add(all);
}

void FlatGroup::refresh()
{
    const Template *one = m_chosen();
    setVisible(one && one->isFlat());
    if (!one || !one->isFlat()) {
        m_preview->hide();
        return;
    }
    m_trace->setEnabled(one->picture || one->curves);
    m_place->setEnabled(!one->isLocked);
    for (QWidget *row : m_ofPictures)
        row->setVisible(one->picture != nullptr);
    if (one->picture && one->picture.get() != m_shown) {
        m_shown = one->picture.get();
        const TemplatePicture sampled = sampledPicture(*one->picture, kSampled);
        m_threshold = static_cast<int>(std::lround(kAll * thresholdOf(sampled, {})));
        m_thresholdField->setNumber(m_threshold);
    }
    if (const auto world = worldFrame(*one, m_bench.session().model()))
        m_turn->setNumber(degrees(turnOf(*world)));
    showPlane();
    preview();
}

/// The plane that it lies on is pressed.
void FlatGroup::showPlane()
{
    const Template *one = m_chosen();
    const auto world = one ? worldFrame(*one, m_bench.session().model()) : std::nullopt;
    const Vec3 normal = world ? Vec3(world->normal().cwiseAbs()) : Vec3(Vec3::Zero());
    const auto isAlong = [&](int axis) { return normal[axis] >= kSameDirectionAs; };
    const bool isOnSection = one && one->on != SectionRef();
    const std::array<bool, 4> lies{!isOnSection && isAlong(1), !isOnSection && isAlong(2),
                                   !isOnSection && isAlong(0), isOnSection};
    for (std::size_t i = 0; i < lies.size(); ++i)
        m_place->findChild<QPushButton *>(QLatin1String("flat.") + QLatin1String(kPlanes[i]))
            ->setChecked(lies[i]);
}

} // namespace fff::ui
