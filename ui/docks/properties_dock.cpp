#include "ui/docks/properties_dock.h"

#include "ui/docks/dock_title.h"
#include "ui/docks/drawing_page.h"
#include "ui/docks/joint_page.h"
#include "ui/docks/model_page.h"
#include "ui/docks/properties_header.h"
#include "ui/docks/section_page.h"
#include "ui/settings/settings.h"
#include "ui/workbench.h"

#include <QScrollArea>
#include <QVBoxLayout>

namespace fff::ui {

PropertiesDock::PropertiesDock(Workbench &bench, QWidget *parent)
    : QDockWidget(tr("Properties"), parent), m_bench(bench)
{
    dressDock(this, "propertiesDock");
    auto *area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus); // its fields have it
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *content = new QWidget(area);
    m_header = new PropertiesHeader(bench, content);
    m_modelPage = new ModelPage(bench, content);
    m_sectionPage = new SectionPage(bench, content);
    m_jointPage = new JointPage(bench, content);
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(16, 12, 12, 12);
    column->setSpacing(0);
    column->addWidget(m_header);
    column->addSpacing(12);
    column->addWidget(m_modelPage);
    column->addWidget(m_sectionPage);
    column->addWidget(m_jointPage);
    m_drawingPage = new DrawingPage(bench, content);
    column->addWidget(m_drawingPage);
    column->addStretch(1);
    area->setWidget(content);
    setWidget(area);

    connect(m_modelPage, &ModelPage::stockWanted, this, &PropertiesDock::stockWanted);
    connect(m_sectionPage, &SectionPage::stockWanted, this, &PropertiesDock::stockWanted);
    // What had the focus is hidden then: it goes on to where one is.
    connect(m_sectionPage, &SectionPage::jointWanted, this, [this](const JointRef &joint) {
        m_bench.setOutlined({});
        m_bench.selectJoint(joint);
        m_jointPage->setFocus();
    });
    connect(m_jointPage, &JointPage::sectionWanted, this,
            [this](const SectionRef &section, const SectionRef &other) {
                m_bench.setOutlined({});
                m_bench.select({section});
                m_sectionPage->focusJoint(other);
            });
    connect(&bench, &Workbench::selectionChanged, this, &PropertiesDock::refresh);
    connect(&bench, &Workbench::pointsChanged, this, &PropertiesDock::refresh);
    connect(&bench.session(), &Session::modelChanged, this, &PropertiesDock::follow);
    connect(&bench.session(), &Session::analysisChanged, this, &PropertiesDock::follow);
    connect(&settings(), &Settings::unitChanged, this, &PropertiesDock::refresh);
    connect(&bench, &Workbench::viewChanged, this, [this] {
        if (m_drawingPage->isWanted() || !m_drawingPage->isHidden())
            follow();
    });
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, &PropertiesDock::refresh);
    connect(this, &QDockWidget::visibilityChanged, this, &PropertiesDock::refresh);
}

/// While something is drawn, each move changes overlay, model and analysis: all at once is enough.
void PropertiesDock::follow()
{
    if (m_drawingPage->isWanted() && !m_drawingPage->isHidden())
        m_soon.start();
    else
        refresh();
}

void PropertiesDock::refresh()
{
    m_soon.stop();
    if (!isVisible())
        return; // once it is seen again
    const bool isDrawing = m_drawingPage->isWanted();
    m_drawingPage->setVisible(isDrawing);
    m_header->setVisible(!isDrawing);
    const bool hasSection = !selectedSections(m_bench).empty();
    const bool hasJoint = m_bench.interaction().selectedJoint().has_value();
    m_jointPage->follow();
    m_modelPage->setVisible(!hasSection && !hasJoint && !isDrawing);
    m_jointPage->setVisible(hasJoint && !isDrawing);
    m_sectionPage->setVisible(hasSection && !isDrawing);
    if (isDrawing) {
        m_drawingPage->refresh();
        return;
    }
    m_header->refresh();
    if (hasJoint)
        m_jointPage->refresh();
    else if (hasSection)
        m_sectionPage->refresh();
    else
        m_modelPage->refresh();
}

} // namespace fff::ui
