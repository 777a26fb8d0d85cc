#include "ui/intake/ImportPanels.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>

#include "ui/kit/Words.h"
#include "ui/kit/fit/LongWords.h"

namespace lubberline::ui {

ProgressStrip::ProgressStrip(QWidget* parent)
    : QFrame(parent)
    , m_what(new QLabel)
    , m_bar(new QProgressBar)
    , m_cancel(new QPushButton(tr("Cancel")))
{
    setObjectName(QStringLiteral("progressStrip"));
    m_cancel->setObjectName(QStringLiteral("cancelJob"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    m_what->setWordWrap(true);
    layout->addWidget(m_what, 2);
    layout->addWidget(m_bar, 1);
    layout->addWidget(m_cancel);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_cancel->setEnabled(false);
        emit cancelled();
    });
    hide();
}

void ProgressStrip::begin(const QString& what)
{
    m_what->setText(breakable(what));
    m_bar->setValue(0);
    m_cancel->setEnabled(true);
    show();
}

void ProgressStrip::setPercent(int percent) { m_bar->setValue(percent); }

NamingStrip::NamingStrip(QWidget* parent)
    : QFrame(parent)
    , m_question(new QLabel)
    , m_aircraft(new QLineEdit)
    , m_type(new QLineEdit)
    , m_compass(new QLineEdit)
{
    setObjectName(QStringLiteral("namingStrip"));
    setFrameShape(StyledPanel);
    m_aircraft->setObjectName(QStringLiteral("namedAircraft"));
    m_aircraft->setPlaceholderText(tr("registration"));
    m_type->setObjectName(QStringLiteral("namedType"));
    m_type->setPlaceholderText(tr("type"));
    m_compass->setObjectName(QStringLiteral("namedCompass"));
    m_compass->setPlaceholderText(tr("compass"));
    auto* import = new QPushButton(tr("Import"));
    import->setObjectName(QStringLiteral("importNamed"));
    auto* cancel = new QPushButton(tr("Cancel"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    m_question->setWordWrap(true);
    layout->addWidget(m_question, 1);
    for (QWidget* widget : {static_cast<QWidget*>(m_aircraft), static_cast<QWidget*>(m_type), static_cast<QWidget*>(m_compass),
             static_cast<QWidget*>(import), static_cast<QWidget*>(cancel)})
        layout->addWidget(widget);
    const auto answer = [this] {
        if (m_aircraft->text().trimmed().isEmpty()) {
            m_aircraft->setFocus();
            return;
        }
        hide();
        emit named(m_path,
            {m_aircraft->text().trimmed().toStdString(), m_type->text().trimmed().toStdString(),
                m_compass->text().trimmed().toStdString()});
    };
    connect(import, &QPushButton::clicked, this, answer);
    for (QLineEdit* line : {m_aircraft, m_type, m_compass})
        connect(line, &QLineEdit::returnPressed, this, answer);
    connect(cancel, &QPushButton::clicked, this, &QWidget::hide);
    hide();
}

void NamingStrip::ask(const QString& path, const CsvParticulars& suggestion)
{
    m_path = path;
    m_question->setText(breakable(tr("Whose swing is %1?").arg(QFileInfo(path).fileName())));
    m_aircraft->setText(toText(suggestion.aircraft));
    m_type->setText(toText(suggestion.type));
    m_compass->setText(toText(suggestion.compass));
    show();
    m_aircraft->setFocus();
    m_aircraft->selectAll();
}

} // namespace lubberline::ui
