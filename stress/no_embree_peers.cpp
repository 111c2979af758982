// SPDX-License-Identifier: Apache-2.0
#include "stress/peer.h"

namespace alidade {

std::vector<std::unique_ptr<StressPeer>> make_embree_peers() { return {}; }

}  // namespace alidade
