// Binds the tables of settings to a session: see filters/core/settings/Setting.h.
#pragma once

#include <span>
#include <vector>

#include "datasets/session/Session.h"
#include "filters/core/settings/SettingsTable.h"

namespace umbra {

std::span<const SettingRow<Session>> pictureTable();

// Binds the rows of all tables to the session, which must outlive the result. If the session sets
// no light or camera, the rows show the given ones of the scene; storing one of their settings
// gives the session a light or camera of its own.
std::vector<Setting> settingsOf(Session& session, const Light& sceneLight = {},
                                const Camera& sceneCamera = {});

// Tells whether the setting belongs to a light or camera, which the scene has if the session has
// none.
bool isOfScene(const SettingInfo& info);

// These bind the rows of one table.
std::vector<Setting> settingsOf(FrameSettings& frame);
std::vector<Setting> settingsOf(Light& light);
std::vector<Setting> settingsOf(Camera& camera);
std::vector<Setting> pictureSettingsOf(Session& session);

// Finds the first stage that has to be done again when `before` becomes `after`: see
// SettingsTable.h. A light or camera counts as changed if only one of the two sessions sets it.
// Probes and panes make nothing stale.
Stage firstStaleStage(const Session& before, const Session& after);

}  // namespace umbra
