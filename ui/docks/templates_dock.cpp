#include "ui/docks/templates_dock.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/template_words.h"
#include "core/session/template_commands.h"
#include "core/templates/flat_template.h"
#include "core/templates/moved_template.h"
#include "core/templates/template_curves.h"
#include "core/templates/template_mesh.h"
#include "core/templates/template_picture.h"
#include "ui/base/icon.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/docks/dock_title.h"
#include "ui/docks/flat_group.h"
#include "ui/docks/making_group.h"
#include "ui/docks/outline_marks.h"
#include "ui/docks/template_source.h"
#include "ui/docks/template_tools.h"
#include "ui/docks/two_lines.h"
#include "ui/properties/property_rows.h"
#include "ui/properties/slider_field.h"
#include "ui/properties/triple_row.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <array>
#include <tuple>

namespace fff::ui {

namespace {

enum TemplateColumn { kTemplateName, kTemplateLock, kTemplateEye, kTemplateColumns };

constexpr int kTemplateRow = 40, kFieldsMargin = 12, kOpacityField = 72; // px
constexpr double kHundred = 100.0;
constexpr NumberEdit::Range kOpacityRange{0.0, kHundred, 5.0, 0, 0};
constexpr LengthEdit::Range kTemplateSizes{0.1, 1e5, 1.0, 1, 3};
constexpr LengthEdit::Range kTemplatePlace{-kMaxCoordinate, kMaxCoordinate, 1.0, 1, 3};
constexpr NumberEdit::Range kTemplateTurn{-360.0, 360.0, 1.0, 0, 2};

double sizeOf(const Template &one)
{
    return one.mesh ? one.scale * one.mesh->mesh->size() : flatSize(one).maxCoeff();
}

bool isRead(const Template &one)
{
    return one.mesh || one.picture || one.curves;
}

} // namespace

TemplatesDock::TemplatesDock(Workbench &bench, QWidget *parent)
    : QDockWidget(tr("Templates"), parent), m_bench(bench)
{
    dressDock(this, "templatesDock");
    auto *content = new QWidget(this);
    auto *add = new QPushButton(themedIcon(QStringLiteral("plus")), tr("Add template…"), content);
    add->setObjectName(QStringLiteral("templateAdd"));
    add->setToolTip(tr("Read a mesh, a picture or a drawing to draw sections after it"));
    connect(add, &QPushButton::clicked, this, &TemplatesDock::addWanted);

    m_empty =
        new QLabel(tr("Add a mesh, a picture or a drawing, or drop or paste one. Sections that "
                      "you draw snap to where their planes cut a mesh, and to the lines of a "
                      "drawing in their plane."),
                   content);
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setContentsMargins(4, 8, 4, 8);

    m_tree = new QTreeWidget(content);
    m_tree->setObjectName(QStringLiteral("templateTree"));
    m_tree->setAccessibleName(tr("Templates"));
    m_tree->setAccessibleDescription(tr("F2 renames, Space hides, L locks, Del removes."));
    m_tree->setColumnCount(kTemplateColumns);
    m_tree->setHeaderHidden(true);
    dressOutline(m_tree, kTemplateEye);
    m_tree->setItemDelegateForColumn(kTemplateName, new TwoLines(m_tree));
    m_tree->setSelectionMode(QAbstractItemView::SingleSelection);
    m_tree->installEventFilter(this);
    connect(m_tree, &QTreeWidget::itemClicked, this, &TemplatesDock::press);
    connect(m_tree, &QTreeWidget::itemChanged, this, &TemplatesDock::rename);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, [this] {
        refreshFields();
        m_tools->follow();
    });

    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(8, 8, 8, 0);
    column->addWidget(add);
    column->addWidget(m_empty);
    column->addWidget(m_tree);
    column->addWidget(makeFields(), 1);
    column->addStretch();
    setWidget(content);
    connect(&bench.session(), &Session::modelChanged, this, &TemplatesDock::followModel);
    followModel();
    refreshFields();
}

QWidget *TemplatesDock::makeFields()
{
    auto *area = m_area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    m_fields = new QWidget(area);
    auto *column = new QVBoxLayout(m_fields);
    column->setContentsMargins(kFieldsMargin, 0, kFieldsMargin, kFieldsMargin);
    column->setSpacing(0);
    m_flat = new FlatGroup(
        m_bench, [this] { return chosen(); }, m_fields);
    connect(m_flat, &FlatGroup::traceWanted, this, &TemplatesDock::traceWanted);
    column->addWidget(m_flat);
    m_group = new PropertyGroup(tr("Place and size"), m_fields);
    const auto add = [this](PropertyRow *row) {
        m_group->add(row);
        m_rows.push_back(row);
    };
    m_tools = new TemplateTools(
        m_bench, [this] { return chosen(); }, m_group);
    connect(m_tools, &TemplateTools::viewWanted, this, &TemplatesDock::viewWanted);
    m_group->add(m_tools);

    auto *percent = new NumberEdit(kOpacityRange, QStringLiteral("%"));
    percent->setFixedWidth(kOpacityField);
    auto *opacity = new SliderField({0.0, kHundred, 5.0, 2}, percent, m_group);
    opacity->setNames("templateOpacitySlider", "templateOpacity.field");
    connect(opacity, &SliderField::settled, this, [this](double value) {
        change([value](Template &one) { one.opacity = value / kHundred; }, steps::kChangeTemplate);
    });
    add(new EditorRow(
        tr("Opacity"), "templateOpacity", opacity,
        [this, opacity] {
            if (const Template *one = chosen())
                opacity->setNumber(kHundred * one->opacity);
        },
        m_group));
    add(new LengthRow(
        tr("Size"), "templateSize", kTemplateSizes,
        [this] { return chosen() ? std::optional(sizeOf(*chosen())) : std::nullopt; },
        [this](double size) {
            change(
                [size, this](Template &one) {
                    if (Result<Template> sized =
                            sizedInPlace(one, size, m_bench.session().committed()))
                        one = *std::move(sized);
                },
                steps::kChangeTemplate);
        },
        m_group));
    addPlaces();
    addContent();
    column->addWidget(m_group);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    for (const auto &[text, id, name, tip] :
         {std::tuple(tr("To the ground"), "template.toGround", "templateToGround",
                     tr("Stand it on the ground")),
          std::tuple(tr("Stand upright"), "template.turnUp", "templateTurnUp",
                     tr("Lay it on its other side: what is up in it is up in the view"))}) {
        auto *button = new QPushButton(text, m_fields);
        button->setObjectName(QLatin1String(name));
        button->setToolTip(tip);
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, [this, command = QLatin1String(id)] {
            if (const Template *one = chosen())
                m_bench.run(command, {{"template", one->name}});
        });
        buttons->addWidget(button);
        if (QLatin1String(id) == QLatin1String("template.turnUp"))
            m_turnUp = button;
    }
    column->addLayout(buttons);
    column->addSpacing(6);
    auto *slices = new QPushButton(themedIcon(QStringLiteral("slices")), tr("Slices…"), m_fields);
    slices->setObjectName(QStringLiteral("templateSlices"));
    slices->setToolTip(tr("Cut it into sections that follow it"));
    slices->setAutoDefault(false);
    connect(slices, &QPushButton::clicked, this, [this] {
        if (const Template *one = chosen())
            Q_EMIT slicesWanted(one->id);
    });
    m_slices = slices;
    column->addWidget(slices);
    column->addSpacing(6);
    column->addWidget(makeMaking());
    column->addStretch();
    area->setWidget(m_fields);
    return area;
}

/// Where its middle is and how it is turned.
void TemplatesDock::addPlaces()
{
    std::array<NumberEdit *, 3> places{}, turns{};
    for (int axis = 0; axis < 3; ++axis) {
        auto *place = new LengthEdit(kTemplatePlace, m_group);
        connect(place, &LengthEdit::lengthEdited, this, [this, axis](double value) {
            change([axis, value](Template &one) { one.frame.origin[axis] = value; },
                   steps::kMoveTemplate);
        });
        auto *turn = new NumberEdit(kTemplateTurn, tr("°"), m_group);
        connect(turn, &NumberEdit::numberEdited, this, [this, axis](double value) {
            change(
                [axis, value](Template &one) {
                    Vec3 all = turnsOf(one);
                    all[axis] = radians(value);
                    one = turnedTo(std::move(one), all);
                },
                steps::kMoveTemplate);
        });
        const std::array names{"X", "Y", "Z"};
        const QLatin1String name(names[static_cast<std::size_t>(axis)]);
        place->setObjectName(QStringLiteral("template") + name);
        turn->setObjectName(QStringLiteral("templateTurn") + name);
        places[static_cast<std::size_t>(axis)] = place;
        turns[static_cast<std::size_t>(axis)] = turn;
    }
    auto *position = new TripleRow(
        tr("Position"), places,
        {tr("X of its middle"), tr("Y of its middle"), tr("Z of its middle")},
        [this](int axis) {
            return chosen() ? std::optional(chosen()->frame.origin[axis]) : std::nullopt;
        },
        m_group);
    auto *turned = new TripleRow(
        tr("Turn"), turns,
        {tr("Turned about X, first"), tr("Turned about Y, after X"), tr("Turned about Z, last")},
        [this](int axis) {
            const Template *one = chosen();
            return one ? std::optional(degrees(turnsOf(*one)[axis]) + 0.0) : std::nullopt;
        },
        m_group);
    for (TripleRow *row : {position, turned}) {
        m_group->add(row);
        m_rows.push_back(row);
    }
    m_turns = turned;
}

void TemplatesDock::addContent()
{
    const auto add = [this](PropertyRow *row) {
        m_group->add(row);
        m_rows.push_back(row);
    };
    add(new TextRow(
        tr("Extent"), "templateExtent",
        [this]() -> QString {
            const Template *one = chosen();
            if (one && one->isFlat() && isRead(*one)) {
                const Vec2 flat = flatSize(*one);
                return sizeText({flat.x(), flat.y()}, 1, locale());
            }
            if (!one || !one->mesh)
                return tr("unknown");
            const Vec3 size = worldBounds(*one, *one->mesh).size();
            return sizeText({size.x(), size.y(), size.z()}, 1, locale());
        },
        m_group));
    m_source = new TemplateSource([this] { return chosen(); }, m_group);
    connect(m_source, &TemplateSource::fileWanted, this, [this](bool isByReference) {
        if (const Template *one = chosen())
            Q_EMIT fileWanted(one->id, isByReference);
    });
    connect(m_source, &TemplateSource::keepWanted, this, [this] {
        if (const Template *one = chosen())
            Q_EMIT keepWanted(one->id);
    });
    m_group->add(m_source);
}

QWidget *TemplatesDock::makeMaking()
{
    m_making = new MakingGroup(m_fields);
    const auto ofChosen = [this](auto wanted) {
        return [this, wanted](auto... number) {
            if (const Template *one = chosen())
                Q_EMIT(this->*wanted)(one->id, number...);
        };
    };
    connect(m_making, &MakingGroup::suggestionWanted, this,
            ofChosen(&TemplatesDock::suggestionWanted));
    connect(m_making, &MakingGroup::oneMoreWanted, this, ofChosen(&TemplatesDock::oneMoreWanted));
    connect(m_making, &MakingGroup::facetsWanted, this, ofChosen(&TemplatesDock::facetsWanted));
    connect(m_making, &MakingGroup::netWanted, this, ofChosen(&TemplatesDock::netWanted));
    connect(m_making, &MakingGroup::anotherWanted, this, &TemplatesDock::anotherWanted);
    return m_making;
}

void TemplatesDock::refreshColours()
{
    writeRows();
}

void TemplatesDock::setHasSuggestion(bool hasLast)
{
    m_making->refresh(m_bench.session().model().sectionCount() > 0, hasLast);
}

void TemplatesDock::followModel()
{
    const std::vector<TemplatePointer> &now = m_bench.session().model().document.templates;
    if (now == m_shown)
        return;
    const bool isNew = now.size() > m_shown.size();
    m_shown = now;
    writeRows();
    if (isNew)
        m_tree->setCurrentItem(m_tree->topLevelItem(m_tree->topLevelItemCount() - 1));
    refreshFields();
}

void TemplatesDock::writeRows()
{
    const QScopedValueRollback filling(m_isFilling, true);
    while (m_tree->topLevelItemCount() > static_cast<int>(m_shown.size()))
        delete m_tree->takeTopLevelItem(m_tree->topLevelItemCount() - 1);
    for (std::size_t i = 0; i < m_shown.size(); ++i) {
        QTreeWidgetItem *item = m_tree->topLevelItem(static_cast<int>(i));
        if (!item) {
            item = new QTreeWidgetItem(m_tree);
            item->setSizeHint(kTemplateName, {0, kTemplateRow});
            item->setFlags(item->flags() | Qt::ItemIsEditable);
        }
        writeRow(item, *m_shown[i]);
    }
    m_tree->setVisible(!m_shown.empty());
    m_empty->setVisible(m_shown.empty());
    m_tree->setFixedHeight(static_cast<int>(m_shown.size()) * kTemplateRow + 4);
}

void TemplatesDock::writeRow(QTreeWidgetItem *item, const Template &one)
{
    item->setIcon(kTemplateName, rowIcon(one.isFlat() ? QStringLiteral("picture")
                                                      : QStringLiteral("figure_polygon")));
    item->setText(kTemplateName, QString::fromStdString(one.name));
    const QString file = QString::fromStdString(one.file);
    const QString content = isRead(one) ? contentOf(one) : tr("%1 is missing").arg(file);
    item->setToolTip(kTemplateName, file);
    item->setData(kTemplateName, kSecondLineRole, content);
    //: %1 is a name, %2 what it is
    item->setData(kTemplateName, Qt::AccessibleTextRole,
                  tr("%1: %2").arg(item->text(kTemplateName), content));
    item->setForeground(
        kTemplateName,
        palette().brush(one.isHidden || !isRead(one) ? QPalette::PlaceholderText : QPalette::Text));
    setMark(item, kTemplateLock,
            one.isLocked ? QStringLiteral("lock") : QStringLiteral("lock_open"),
            rowIcon(one.isLocked ? QStringLiteral("lock") : QStringLiteral("lock_open")),
            one.isLocked ? tr("Unlock") : tr("Lock"));
    setMark(item, kTemplateEye, one.isHidden ? QStringLiteral("eye_off") : QStringLiteral("eye"),
            rowIcon(one.isHidden ? QStringLiteral("eye_off") : QStringLiteral("eye")),
            one.isHidden ? tr("Show") : tr("Hide"));
}

void TemplatesDock::rename(QTreeWidgetItem *item)
{
    const int row = m_tree->indexOfTopLevelItem(item);
    if (m_isFilling || row < 0)
        return;
    const QScopedValueRollback filling(m_isFilling, true);
    const Template &one = *m_shown[static_cast<std::size_t>(row)];
    const QString name = typedName(item, QString::fromStdString(one.name));
    if (name.isEmpty())
        return;
    // Only after the editor has gone: the commit writes the row anew.
    QMetaObject::invokeMethod(
        this,
        [this, name] {
            change([name](Template &changed) { changed.name = name.toStdString(); },
                   steps::kChangeTemplate);
        },
        Qt::QueuedConnection);
}

void TemplatesDock::press(QTreeWidgetItem *item, int column)
{
    m_tree->setCurrentItem(item);
    if (column == kTemplateEye)
        key(Qt::Key_Space);
    else if (column == kTemplateLock)
        key(Qt::Key_L);
    else
        m_tools->hold();
}

bool TemplatesDock::key(int key)
{
    const Template *one = chosen();
    if (!one)
        return false;
    switch (key) {
    case Qt::Key_Space:
        change([](Template &changed) { changed.isHidden = !changed.isHidden; },
               one->isHidden ? steps::kShowTemplate : steps::kHideTemplate);
        return true;
    case Qt::Key_L:
        change([](Template &changed) { changed.isLocked = !changed.isLocked; },
               steps::kChangeTemplate);
        return true;
    case Qt::Key_Delete:
        m_bench.run(QStringLiteral("template.remove"), {{"template", one->name}});
        return true;
    case Qt::Key_Escape:
        return m_tools->escape();
    default:
        return false;
    }
}

bool TemplatesDock::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_tree && event->type() == QEvent::KeyPress &&
        key(static_cast<QKeyEvent *>(event)->key()))
        return true;
    return QDockWidget::eventFilter(watched, event);
}

const Template *TemplatesDock::chosen() const
{
    const int row = m_tree->indexOfTopLevelItem(m_tree->currentItem());
    return row < 0 || row >= static_cast<int>(m_shown.size())
               ? nullptr
               : m_shown[static_cast<std::size_t>(row)].get();
}

QString TemplatesDock::contentOf(const Template &one) const
{
    if (one.mesh)
        return tr("Mesh, %n triangle(s)", nullptr,
                  static_cast<int>(one.mesh->mesh->triangles().size()));
    if (one.picture)
        //: %1 and %2 are numbers of pixels
        return tr("Picture, %1 × %2 pixels")
            .arg(locale().toString(one.picture->width), locale().toString(one.picture->height));
    return tr("Drawing, %n line(s)", nullptr,
              one.curves ? static_cast<int>(one.curves->lines.size()) : 0);
}

/// A locked one stays as it lies; it can be hidden, renamed and unlocked.
void TemplatesDock::change(const std::function<void(Template &)> &change, Text step)
{
    const Template *one = chosen();
    const Document &document = m_bench.session().committed().document;
    const Template *committed = one ? document.find(one->id) : nullptr;
    if (!committed)
        return;
    Template next = *committed;
    change(next);
    const bool isHeld = committed->isLocked && next.isLocked && !next.hasFormOf(*committed);
    // What it cannot be is put right by the fields below.
    if (const auto edit = changedTemplate(document, next, step); edit && !isHeld)
        m_bench.editSections(*edit);
    refreshFields(); // what was refused goes back to what it was
}

void TemplatesDock::refreshFields()
{
    const Template *one = chosen();
    m_area->setVisible(one != nullptr);
    if (!one)
        return;
    m_group->setEnabled(!one->isLocked);
    for (QWidget *ofMeshes : {static_cast<QWidget *>(m_slices), static_cast<QWidget *>(m_making),
                              static_cast<QWidget *>(m_turnUp)})
        ofMeshes->setVisible(!one->isFlat());
    m_turns->setVisible(!one->isFlat());
    m_source->refresh();
    m_flat->refresh();
    m_tools->refresh();
    for (PropertyRow *row : m_rows)
        row->refresh();
}

} // namespace fff::ui
