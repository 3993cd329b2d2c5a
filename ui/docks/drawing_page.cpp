#include "ui/docks/drawing_page.h"

#include "core/base/units.h"
#include "ui/base/icon.h"
#include "ui/base/rich_text.h"
#include "ui/base/theme.h"
#include "ui/bench/marked_scene.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/stock_choice.h"
#include "ui/view/heading_weight.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

/// Upright enough to be called up or down (cosine of 45°).
constexpr double kUpright = 0.7071;

/// Index of the section of the preview that is being drawn or changed, or -1.
int drawnIndex(const Workbench &bench)
{
    const Model &model = bench.session().model(), &committed = bench.session().committed();
    if (!bench.session().hasPreview())
        return -1;
    for (std::size_t i = model.sectionCount(); i-- > 0;) {
        if (i >= committed.sectionCount() || model.section(i) != committed.section(i))
            return static_cast<int>(i);
    }
    return -1;
}

/// Null where nothing can be followed.
const sign::FollowedGuide *followed(const Overlay &overlay)
{
    const auto *guides = overlay.find<sign::Guides>();
    return guides && guides->followed ? &*guides->followed : nullptr;
}

QString kindText(const Overlay &overlay)
{
    using Purpose = ContourTarget::Purpose;
    const auto *stroke = overlay.find<sign::Stroke>();
    const auto *path = overlay.find<PenMarks>();
    const Purpose purpose = stroke ? stroke->purpose : path ? path->purpose : Purpose::NewSection;
    if (purpose == Purpose::Hole)
        return DrawingPage::tr("A hole, while you draw it");
    if (purpose == Purpose::Redraw)
        return DrawingPage::tr("A new contour, while you draw it");
    return stroke || path ? DrawingPage::tr("New section, while you draw it")
                          : DrawingPage::tr("Its contour comes next");
}

} // namespace

DrawingPage::DrawingPage(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    constexpr int kIconSize = 34;
    m_icon = new QLabel(this);
    m_icon->setObjectName(QStringLiteral("drawnIcon"));
    m_icon->setFixedSize(kIconSize, kIconSize);
    m_icon->setAlignment(Qt::AlignCenter);
    m_name = new QLabel(this);
    m_name->setObjectName(QStringLiteral("drawnName"));
    QFont bold = m_name->font();
    bold.setWeight(headingWeight());
    m_name->setFont(bold);
    m_kind = new QLabel(this);
    m_kind->setObjectName(QStringLiteral("drawnKind"));
    m_kind->setForegroundRole(QPalette::PlaceholderText);
    auto *head = new QGridLayout;
    head->setHorizontalSpacing(10);
    head->setVerticalSpacing(6);
    head->addWidget(m_icon, 0, 0);
    head->addWidget(m_name, 0, 1);
    head->addWidget(m_kind, 1, 1);
    head->setColumnStretch(1, 1);

    const Session &session = bench.session();
    auto *stock = new PropertyGroup(tr("Stock"), this);
    const auto current = [this, &session]() -> const Stock & {
        const Model &model = session.model();
        const int drawn = drawnIndex(m_bench);
        return drawn < 0 ? *model.document.find(model.document.currentStock)
                         : model.stockOf(static_cast<std::size_t>(drawn));
    };
    addRow(stock, tr("Stock"), "drawnStock", [current] { return stockName(current()); });
    addRow(stock, tr("Thickness"), "drawnThickness",
           [this, current] { return lengthText(current().thickness, 2, 3, locale()); });

    m_slit = new PropertyGroup(tr("Slit"), this);
    addRow(m_slit, tr("On"), "drawnParent", [this] {
        const auto *slit = m_bench.interaction().overlay().find<sign::Slit>();
        return slit ? QString::fromStdString(slit->section) : QString(u'–');
    });
    addRow(m_slit, tr("Length"), "drawnSlitLength", [this] {
        const auto *slit = m_bench.interaction().overlay().find<sign::Slit>();
        return slit ? lengthText((slit->to - slit->from).norm(), 1, 1, locale()) : QString(u'–');
    });
    addRow(m_slit, tr("Its own slit"), "drawnOwnSlit", [this] { return ownSlit(); });

    m_contour = new PropertyGroup(tr("Contour"), this);
    addRow(m_contour, tr("Size"), "drawnSize", [this] {
        const auto *stroke = m_bench.interaction().overlay().find<sign::Stroke>();
        if (const int drawn = drawnIndex(m_bench); !stroke && drawn >= 0) {
            const Vec2 size = m_bench.session()
                                  .model()
                                  .section(static_cast<std::size_t>(drawn))
                                  ->shape->bounds()
                                  .size();
            return sizeText({size.x(), size.y()}, 1, locale());
        }
        if (!stroke || !stroke->size)
            return QString(u'–');
        return sizeText({stroke->size->x(), stroke->size->y()}, 1, locale());
    });
    addRow(m_contour, tr("Curve pieces"), "drawnPieces", [this] {
        const auto *stroke = m_bench.interaction().overlay().find<sign::Stroke>();
        return stroke && stroke->pieces > 0 ? locale().toString(stroke->pieces) : QString(u'–');
    });
    addRow(m_contour, tr("Mass"), "drawnMass", [this] {
        const int drawn = drawnIndex(m_bench);
        return drawn < 0 ? QString(u'–')
                         : massText(Measures(m_bench.session()).mass(drawn), locale());
    });

    m_template = new PropertyGroup(tr("Template"), this);
    const auto addFollowed = [this](const QString &name, const char *objectName, auto read) {
        addRow(m_template, name, objectName, [this, read] {
            const auto *told = followed(m_bench.interaction().overlay());
            return told ? read(*told) : QString(u'–');
        });
    };
    using Told = sign::FollowedGuide;
    addFollowed(tr("Follows"), "drawnFollows",
                [](const Told &told) { return QString::fromStdString(told.name); });
    addFollowed(tr("On the guide"), "drawnOnGuide", [this](const Told &told) {
        constexpr double kPercent = 100.0;
        //: %1 is a number: of the line that somebody draws
        return told.isBegun ? tr("%1 % of the stroke")
                                  .arg(locale().toString(std::lround(kPercent * told.share)))
                            : QString(u'–');
    });
    addFollowed(tr("Farthest off"), "drawnFarthest", [this](const Told &told) {
        return told.isBegun ? lengthText(told.farthest, 1, 1, locale()) : QString(u'–');
    });

    m_why = new QLabel(this);
    m_why->setObjectName(QStringLiteral("drawnSymmetry"));
    m_why->setWordWrap(true);
    m_why->setMargin(10);
    m_why->setTextFormat(Qt::RichText);
    m_why->setAutoFillBackground(true);
    m_why->setFrameShape(QFrame::StyledPanel);

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(head);
    column->addSpacing(12);
    column->addWidget(stock);
    column->addWidget(m_slit);
    column->addWidget(m_contour);
    column->addWidget(m_template);
    column->addWidget(m_why);
}

void DrawingPage::addRow(PropertyGroup *group, const QString &name, const char *objectName,
                         std::function<QString()> read)
{
    auto *row = new TextRow(name, objectName, std::move(read), group);
    group->add(row);
    m_rows.push_back(row);
}

bool DrawingPage::isWanted() const
{
    const Overlay &overlay = m_bench.interaction().overlay();
    return overlay.find<sign::Slit>() || overlay.find<sign::Stroke>() || hasPath(overlay);
}

/// Which way it opens and how deep it is, as far as that is known by now.
QString DrawingPage::ownSlit() const
{
    const int drawn = drawnIndex(m_bench);
    const Analysis &analysis = m_bench.session().analysis();
    if (drawn < 0)
        return QString(u'–');
    const int there =
        analysis.model.indexOf(m_bench.session().model().ref(static_cast<std::size_t>(drawn)));
    if (there < 0)
        return QString(u'…');
    // An older analysis may be of another section that had this id.
    const std::optional<Parent> &on =
        m_bench.session().model().section(static_cast<std::size_t>(drawn))->parent;
    if (!(analysis.model.section(static_cast<std::size_t>(there))->parent == on))
        return QString(u'…');
    const auto &slits = analysis.assembly.slits[static_cast<std::size_t>(there)];
    const int guest = on ? analysis.model.indexOf(on->section) : -1;
    const auto own = std::find_if(slits.begin(), slits.end(), [guest](const Slit &s) {
        return s.guest == guest && s.overlap >= 0;
    });
    if (own == slits.end())
        return tr("none");
    const Slit &slit = *own;
    if (slit.role != SlitRole::Slit)
        return tr("tabs");
    if (!slit.isOpen)
        return tr("closed");
    const Joint &joint = analysis.assembly.joints[static_cast<std::size_t>(slit.joint - 1)];
    const Overlap &shared = joint.crossing->overlaps[static_cast<std::size_t>(slit.overlap)];
    const Interval &interval = joint.a == there ? shared.a : shared.b;
    const Frame &frame = analysis.model.section(static_cast<std::size_t>(there))->frame;
    const Vec3 way = frame.directionToWorld((slit.mouth - slit.inner).normalized());
    const bool isForward = way.dot(joint.crossing->axis.direction) > 0.0;
    const double meets = shared.meet;
    const QString depth =
        lengthText(isForward ? interval.to.at - meets : meets - interval.from.at, 1, 1, locale());
    if (way.y() > kUpright)
        return tr("opens up, %1 deep").arg(depth);
    if (way.y() < -kUpright)
        return tr("opens down, %1 deep").arg(depth);
    return tr("opens sideways, %1 deep").arg(depth);
}

/// Why it is mirrored, or what it would take; empty where there is nothing to say.
QString DrawingPage::symmetryText() const
{
    const auto *stroke = m_bench.interaction().overlay().find<sign::Stroke>();
    if (!stroke || !stroke->symmetry || !stroke->symmetry->isOneSided)
        return {};
    const SymmetryVerdict &sides = *stroke->symmetry;
    const QString far = lengthText(std::max(sides.left, sides.right), 1, 1, locale());
    const QString near = lengthText(std::min(sides.left, sides.right), 1, 1, locale());
    if (!stroke->isMirrored && !stroke->isAxisSlit)
        return {}; // nobody expects the first section to be
    if (!stroke->doHalvesMeet)
        return tr("<b>Not mirrored.</b> The two halves would not meet at the slit.");
    if (!stroke->isMirrored)
        return tr("<b>Not mirrored.</b> You drew on one side of the axis: %1 on one side, %2 on "
                  "the other. Symmetry is off, or Shift is held.")
            .arg(far, near);
    return tr("<b>Mirrored.</b> You drew on one side of the axis: %1 on one side, %2 on the "
              "other. Cross it by %3 or more to draw both sides yourself.")
        .arg(far, near, lengthText(sides.limit, 1, 1, locale()));
}

void DrawingPage::refresh()
{
    const Session &session = m_bench.session();
    m_icon->setPixmap(
        tintedPixmap(QStringLiteral("redraw"), 22, theme().accent, devicePixelRatioF()));
    const int drawn = drawnIndex(m_bench);
    m_name->setText(drawn < 0
                        ? tr("New section")
                        : QString::fromStdString(
                              session.model().section(static_cast<std::size_t>(drawn))->name));
    m_kind->setText(kindText(m_bench.interaction().overlay()));
    m_slit->setVisible(m_bench.interaction().overlay().find<sign::Slit>() != nullptr);
    m_template->setVisible(followed(m_bench.interaction().overlay()) != nullptr);
    for (PropertyRow *row : m_rows)
        row->refresh();
    const QString why = symmetryText();
    m_why->setVisible(!why.isEmpty());
    m_why->setText(keepingUnits(why));
    QPalette soft = m_why->palette();
    soft.setColor(QPalette::Window, theme().soft);
    soft.setColor(QPalette::WindowText, theme().text);
    m_why->setPalette(soft);
}

} // namespace fff::ui
