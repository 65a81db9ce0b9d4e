// SPDX-License-Identifier: MIT
// Tells systemd how the service is (sd_notify(3)).
#pragma once

#include <string_view>

/// Sends "READY=1" and the like where $NOTIFY_SOCKET says whom to; nothing else happens.
void notify(std::string_view state);
