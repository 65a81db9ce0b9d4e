// SPDX-License-Identifier: MIT
// Notification of systemd about the service's state (sd_notify(3)).
#pragma once

#include <string_view>

/// Sends a state such as "READY=1" to $NOTIFY_SOCKET. Does nothing without this variable.
void notify(std::string_view state);
