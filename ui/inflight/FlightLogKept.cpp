// Where a log in flight begins: at what is kept with the compass; and what of it is kept.

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QPushButton>

#include <algorithm>

#include "core/inflight/FlownModel.h"
#include "core/inflight/InflightSwing.h"
#include "core/record/DefaultNames.h"
#include "ui/inflight/FlightLogPage.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/ControlFit.h"

namespace lubberline::ui {

namespace {

constexpr double kOver_nT = 20'000; ///< that P, Q and R of a kept model are counted over: of any the same comes out

/// What is stored of a log, the same in every language.
std::string fromLog(const QString& path) { return "from the log " + QFileInfo(path).fileName().toStdString(); }

} // namespace

/// A continuous swing goes on from what the swings in flight on record tell; a compass that was corrected since begins anew.
void FlightLogPage::takeFlown()
{
    m_before.reset();
    m_flown = 0;
    const auto rows = m_stores.swings.swingsOf(m_compass.id); // newest first
    std::vector<Swing> flown;
    for (const SwingRow& row : rows ? *rows : std::vector<SwingRow>()) {
        if (row.superseded)
            continue;
        if (row.kind != SwingKind::Air)
            break;
        if (auto swing = m_stores.swings.swing(row.id))
            flown.push_back(std::move(swing.value()));
    }
    std::reverse(flown.begin(), flown.end());
    m_before = stateAfter(flown);
    m_flown = m_before ? static_cast<int>(flown.size()) : 0;
}

/// The newest that a flight can go on from is chosen, where no other swing was made since it was stored: a compass that was swung on the
/// ground may have been corrected.
void FlightLogPage::takeModels()
{
    const int before = m_from->currentIndex();
    const RecordId chosen = before > 0 ? m_models[static_cast<std::size_t>(before - 1)].record.record : RecordId();
    const bool first = m_from->count() == 0;
    const auto sensors = m_stores.sensors.of(m_compass.id);
    m_models.clear();
    for (const SensorRecord& sensor : sensors ? *sensors : std::vector<SensorRecord>())
        if (auto state = stateOf(sensor, kOver_nT))
            m_models.push_back({sensor, std::move(*state)});
    m_from->clear();
    m_from->addItem(tr("begins anew"));
    int choice = 0;
    for (const Model& model : m_models) {
        m_from->addItem(tr("goes on from %1").arg(toText(model.record.name)));
        if (model.record.record == chosen)
            choice = m_from->count() - 1;
    }
    if (first && !m_models.empty() && !swungSince(m_models.front().record))
        choice = 1;
    m_from->setCurrentIndex(choice);
    m_from->setVisible(m_whole->isChecked() && !m_models.empty());
    finishControls(*this);
}

/// Whether the compass was swung other than in flight after a record was stored.
bool FlightLogPage::swungSince(const SensorRecord& sensor) const
{
    const auto trail = m_stores.signing.auditOf(sensor.record);
    const auto rows = m_stores.swings.swingsOf(m_compass.id); // newest first
    if (!trail || trail->empty() || !rows)
        return true;
    const auto stored = Date::read(std::string_view(trail->front().timeUtc).substr(0, 10));
    const auto other
        = std::find_if(rows->begin(), rows->end(), [](const SwingRow& row) { return !row.superseded && row.kind != SwingKind::Air; });
    return !stored || (other != rows->end() && *stored < other->date);
}

void FlightLogPage::fleetChanged()
{
    if (!m_compass.id.valid())
        return;
    takeFlown();
    takeModels();
}

std::optional<ContinuousState> FlightLogPage::begin() const
{
    if (!m_whole->isChecked())
        return m_before;
    const int choice = m_from->currentIndex();
    return choice > 0 ? std::optional(m_models[static_cast<std::size_t>(choice - 1)].state) : std::nullopt;
}

QString FlightLogPage::begunAt() const
{
    if (!m_whole->isChecked())
        return m_flown > 0 ? tr("It goes on from %n swing(s) in flight on record, recomputed from their readings.", nullptr, m_flown)
                           : QString();
    const int choice = m_from->currentIndex();
    if (choice <= 0)
        return {};
    const SensorRecord& record = m_models[static_cast<std::size_t>(choice - 1)].record;
    if (record.note == fromLog(m_path))
        return tr("The sensor model %1 was kept from a log of this name: if it is the same, it counts twice. Begin anew.")
            .arg(toText(record.name));
    return tr("It goes on from the sensor model %1.").arg(toText(record.name));
}

void FlightLogPage::make()
{
    Swing swing = m_swing;
    swing.compass = m_compass.id;
    swing.note = fromLog(m_path);
    emit makeSwing(swing);
}

void FlightLogPage::keepModel()
{
    const auto* continuous = m_log ? std::get_if<ContinuousResult>(&m_log->solved) : nullptr;
    auto sensor = continuous ? flownModel(*continuous, m_begunAt) : std::nullopt;
    const auto others = m_stores.sensors.of(m_compass.id);
    if (!sensor || !others) {
        refuse(others ? tr("Nothing to keep yet; open a log first") : messageOf(others.error()));
        return;
    }
    sensor->compass = m_compass.id;
    sensor->name
        = freeName("in flight, " + QFileInfo(m_path).completeBaseName().toStdString(), *others, [](const auto& one) { return one.name; });
    sensor->note = fromLog(m_path);
    m_keep->setEnabled(false); // once
    emit storeModel(*sensor);
    takeModels();
    const auto kept = std::find_if(m_models.begin(), m_models.end(), [&](const Model& model) { return model.record.name == sensor->name; });
    if (kept == m_models.end())
        return; // refused, and told
    m_from->setCurrentIndex(static_cast<int>(kept - m_models.begin()) + 1);
    say(message() + '\n' + tr("It is kept with the compass as %1.").arg(toText(sensor->name)));
}

} // namespace lubberline::ui
