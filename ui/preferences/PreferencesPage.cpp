#include "ui/preferences/PreferencesPage.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/kit/PageDescription.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kWidth = 560;

QSpinBox* percentBox(const QString& name)
{
    auto* box = new QSpinBox;
    box->setObjectName(name);
    box->setRange(Preferences::kSmallest_percent, Preferences::kLargest_percent);
    box->setSingleStep(Preferences::kStep_percent);
    box->setSuffix(QStringLiteral(" %"));
    return box;
}

QComboBox* choices(const QString& name, const std::vector<std::pair<QString, QVariant>>& items)
{
    auto* box = new QComboBox;
    box->setObjectName(name);
    for (const auto& [text, value] : items)
        box->addItem(text, value);
    return box;
}

/// What is chosen but is there no more is said, and stays chosen until another is.
void choose(QComboBox& box, const QVariant& value)
{
    if (box.findData(value) < 0)
        box.addItem(PreferencesPage::tr("one that is not in this database"), value);
    box.setCurrentIndex(box.findData(value));
}

QFormLayout* group(QVBoxLayout& column, const QString& title)
{
    auto* box = new QGroupBox(title);
    auto* form = new QFormLayout(box);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    column.addWidget(box);
    return form;
}

} // namespace

PreferencesPage::PreferencesPage(PageContext& context, QWidget* parent)
    : Page(parent)
    , m_context(context)
    , m_preferences(*context.preferences)
    , m_language(choices(QStringLiteral("preferLanguage"),
          {{tr("as the system"), QString()}, {QStringLiteral("English"), QStringLiteral("en")},
              {QStringLiteral("Polski"), QStringLiteral("pl")}}))
    , m_angles(choices(QStringLiteral("preferAngles"), {{tr("decimal degrees (3.25°)"), false}, {tr("degrees and minutes (3°15')"), true}}))
    , m_theme(choices(QStringLiteral("preferTheme"), {{tr("light"), false}, {tr("dark"), true}}))
    , m_site(new QComboBox)
    , m_instrument(new QComboBox)
    , m_textSize(percentBox(QStringLiteral("preferTextSize")))
    , m_rampSize(percentBox(QStringLiteral("preferRampSize")))
    , m_kept(new QSpinBox)
    , m_folder(new QLineEdit)
    , m_reopen(new QPushButton(tr("Open the &window anew")))
{
    setTitle(tr("Preferences"));
    m_site->setObjectName(QStringLiteral("preferSite"));
    m_instrument->setObjectName(QStringLiteral("preferInstrument"));
    m_kept->setObjectName(QStringLiteral("preferBackupsKept"));
    m_kept->setRange(1, Preferences::kMostBackups);
    m_folder->setObjectName(QStringLiteral("preferBackupFolder"));
    m_reopen->setObjectName(QStringLiteral("reopenWindow"));
    auto* inner = new QWidget;
    inner->setMaximumWidth(kWidth * 2);
    auto* column = new QVBoxLayout(inner);
    buildLook(*group(*column, tr("How it looks")));
    buildDefaults(*group(*column, tr("What a new swing begins with")));
    buildBackups(*group(*column, tr("Backups")));
    column->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidget(inner);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    body().addWidget(scroll, 1);
    setFocusProxy(m_language);
    connect(&m_preferences, &Preferences::changed, this, &PreferencesPage::showChoices);
    showChoices();
}

void PreferencesPage::buildLook(QFormLayout& form)
{
    auto* language = new QHBoxLayout;
    language->addWidget(m_language);
    language->addWidget(m_reopen);
    form.addRow(tr("&Language:"), language);
    static_cast<QLabel*>(form.labelForField(language))->setBuddy(m_language);
    form.addRow(tr("&Angles:"), m_angles);
    form.addRow(tr("&Theme:"), m_theme);
    form.addRow(tr("Te&xt size:"), m_textSize);
    form.addRow(tr("Text size on the &ramp:"), m_rampSize);
    m_rampSize->setToolTip(tr("Of the pages of a guided swing, on top of the text size"));
    connect(m_language, &QComboBox::activated, this, &PreferencesPage::chooseLanguage);
    connect(m_reopen, &QPushButton::clicked, this, [this] { m_context.reopen(); });
    connect(m_angles, &QComboBox::activated, this, [this] {
        m_preferences.setAngleStyle(m_angles->currentData().toBool() ? AngleStyle::DegreesMinutes : AngleStyle::DecimalDegrees);
    });
    connect(m_theme, &QComboBox::activated, this, [this] { m_preferences.setDark(m_theme->currentData().toBool()); });
    connect(m_textSize, &QSpinBox::valueChanged, &m_preferences, &Preferences::setTextSize_percent);
    connect(m_rampSize, &QSpinBox::valueChanged, &m_preferences, &Preferences::setRampSize_percent);
    m_reopen->hide();
}

void PreferencesPage::buildDefaults(QFormLayout& form)
{
    form.addRow(tr("&Compass base:"), m_site);
    form.addRow(tr("&Datum instrument:"), m_instrument);
    connect(m_site, &QComboBox::activated, this, [this] { m_preferences.setSite(m_site->currentData().toString()); });
    connect(m_instrument, &QComboBox::activated, this, [this] { m_preferences.setInstrument(m_instrument->currentData().toString()); });
}

void PreferencesPage::buildBackups(QFormLayout& form)
{
    auto* folder = new QHBoxLayout;
    auto* pick = new QPushButton(tr("C&hoose…"));
    pick->setObjectName(QStringLiteral("chooseBackupFolder"));
    m_folder->setMinimumWidth(280);
    m_folder->setPlaceholderText(tr("asked for each time"));
    folder->addWidget(m_folder);
    folder->addWidget(pick);
    form.addRow(tr("Fo&lder:"), folder);
    static_cast<QLabel*>(form.labelForField(folder))->setBuddy(m_folder);
    form.addRow(tr("Backups &kept:"), m_kept);
    m_kept->setToolTip(tr("When there are more of this database in the folder, the oldest go"));
    connect(m_folder, &QLineEdit::editingFinished, this, [this] { m_preferences.setBackupFolder(m_folder->text().trimmed()); });
    connect(pick, &QPushButton::clicked, this, &PreferencesPage::chooseBackupFolder);
    connect(m_kept, &QSpinBox::valueChanged, &m_preferences, &Preferences::setBackupsKept);
}

void PreferencesPage::fillDefaults()
{
    m_site->clear();
    m_site->addItem(tr("none"), QString());
    if (const auto sites = m_context.stores.sites.sites(); sites)
        for (const Site& site : *sites)
            m_site->addItem(toText(site.name), toText(site.record));
    m_instrument->clear();
    m_instrument->addItem(tr("none"), QString());
    if (const auto instruments = m_context.stores.sites.instruments(); instruments)
        for (const DatumInstrument& instrument : *instruments)
            m_instrument->addItem(toText(instrument.name), toText(instrument.record));
}

void PreferencesPage::showChoices()
{
    const QSignalBlocker texts(m_textSize), ramp(m_rampSize), kept(m_kept);
    choose(*m_language, m_preferences.language());
    choose(*m_angles, m_preferences.angleStyle() == AngleStyle::DegreesMinutes);
    choose(*m_theme, m_preferences.dark());
    m_textSize->setValue(m_preferences.textSize_percent());
    m_rampSize->setValue(m_preferences.rampSize_percent());
    m_kept->setValue(m_preferences.backupsKept());
    if (!m_folder->hasFocus())
        m_folder->setText(m_preferences.backupFolder());
    fillDefaults();
    choose(*m_site, m_preferences.site());
    choose(*m_instrument, m_preferences.instrument());
}

void PreferencesPage::chooseLanguage()
{
    m_preferences.setLanguage(m_language->currentData().toString());
    m_reopen->setVisible(static_cast<bool>(m_context.reopen));
    say(tr("The language is another when the window is opened anew."));
}

void PreferencesPage::chooseBackupFolder()
{
    const QString folder = m_context.dialogs.chooseFolder(window(), tr("Folder for backups"), m_preferences.backupFolder());
    if (!folder.isEmpty())
        m_preferences.setBackupFolder(folder);
}

Result<void> PreferencesPage::open(const FleetItem&)
{
    showChoices();
    return {};
}

PageDescription PreferencesPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("preferences"), [&context] { return new PreferencesPage(context); }};
    page.commands = {{MenuId::Edit, 900, tr("Pr&eferences…"), tr("Ctrl+,"), "preferences", [&context](Page&) {
                          context.go({"preferences", {}, true});
                      }}};
    page.help = tr(
        "What is chosen once for all: language, how angles are written, light or dark, text sizes, what a new swing begins with, and where backups go. A choice holds at once.");
    return page;
}

} // namespace lubberline::ui
