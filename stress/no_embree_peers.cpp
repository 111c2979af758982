// SPDX-License-Identifier: Apache-2.0
#include "bench/peer.h"

namespace alidade::bench {

std::vector<std::unique_ptr<Peer>> make_embree_peers() { return {}; }

}  // namespace alidade::bench
