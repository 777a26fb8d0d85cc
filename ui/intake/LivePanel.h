#pragma once
/// A live source on a strip: where it comes from, what it says, whether it has settled; one key each takes it as datum or
/// compass.

#include <QWidget>

#include <functional>
#include <optional>
#include <set>

#include "core/angle/Heading.h"
#include "ui/intake/LiveHeading.h"
#include "ui/intake/LiveInput.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSettings;
class QTimer;

namespace lubberline::ui {

/// What the datum of the swing is, as far as a live heading can be it.
struct LiveDatum {
    bool isSent = true;                  ///< by an instrument; else a person reads it, and no sentence is its figure
    bool isTrue = false;                 ///< it shows headings from true north
    std::optional<double> variation_deg; ///< of the swing, east positive
};

class LivePanel : public QWidget {
    Q_OBJECT

public:
    /// @param now_s as LiveHeading takes it.
    explicit LivePanel(std::function<double()> now_s = {}, QWidget* parent = nullptr);

    void setDatum(const LiveDatum& datum);
    /// Begins with the source of the last time, and remembers the one that is connected.
    void rememberIn(QSettings& settings);
    [[nodiscard]] LiveInput& input() { return *m_input; }
    [[nodiscard]] LiveHeading& heading() { return *m_heading; }
    void takeDatum();   ///< F6
    void takeCompass(); ///< F7

signals:
    /// A settled heading, from the north of the datum.
    void datumSettled(double heading_deg);
    void compassSettled(double heading_deg);
    void failed(const QString& message);

private:
    void build();
    void connectOrClose();
    void showState();
    void showHeadings();
    void showNotes();
    [[nodiscard]] QString turnWords(const QString& channel) const;
    void keepChannels(QComboBox& box, const QStringList& channels, const QString& best);
    void showHeading(const QString& channel, QLabel& figure, QLabel& detail) const;
    [[nodiscard]] QString settlingWords(const QString& channel) const;
    /// From the north of the datum; none: the variation of the swing is missing.
    [[nodiscard]] std::optional<double> asDatum_deg(const QString& channel, double heading_deg) const;
    [[nodiscard]] QString northWords(const QString& channel) const;
    [[nodiscard]] std::optional<SettledHeading> settled(const QComboBox& box);

    LiveInput* m_input;
    LiveHeading* m_heading;
    QComboBox* m_kind;
    QLineEdit* m_where;
    QPushButton* m_connect;
    QLabel* m_state;
    QComboBox *m_datum, *m_compass;
    QLabel *m_datumValue, *m_datumDetail, *m_compassValue, *m_compassDetail, *m_notes;
    QPushButton *m_useDatum, *m_useCompass;
    QTimer* m_silence;
    QSettings* m_settings = nullptr;
    LiveDatum m_expected;
    std::set<QComboBox*> m_chosen; ///< those in which somebody chose
    int m_heard = 0;               ///< sentences when it was looked last
    int m_silent_s = 0;
};

} // namespace lubberline::ui
