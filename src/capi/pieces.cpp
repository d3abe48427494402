#include <algorithm>

#include "capi/guard.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

// Number of the piece if there is exactly one; 0 if there are several or none.
std::int32_t only_piece(const std::vector<int>& pieces) { return pieces.size() == 1 ? pieces.front() : 0; }

}  // namespace

bempd_status bempd_piece_count(bempd_model* model, int64_t* count) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(count, "count") = static_cast<int64_t>(m.pieces().all().nodes.size());
  });
}

bempd_status bempd_copy_node_pieces(bempd_model* model, int32_t region, int64_t capacity, int32_t* pieces) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(pieces, "pieces");
    const std::vector<int> found = m.pieces().of_nodes_in(region);
    const auto count = static_cast<int64_t>(found.size());
    require(capacity >= count, "capacity is ", capacity, " integers; ", count, " are needed");
    std::copy(found.begin(), found.end(), pieces);
  });
}

bempd_status bempd_support_piece(bempd_model* model, int32_t support, int32_t* piece) {
  return with_model(model, __func__,
                    [&](model::Model& m) { out(piece, "piece") = only_piece(m.pieces().of_support(support)); });
}

bempd_status bempd_load_piece(bempd_model* model, int32_t load, int32_t* piece) {
  return with_model(model, __func__,
                    [&](model::Model& m) { out(piece, "piece") = only_piece(m.pieces().of_load(load)); });
}

bempd_status bempd_are_connected(bempd_model* model, int32_t support, int32_t other, int32_t* connected) {
  return with_model(model, __func__, [&](model::Model& m) {
    out(connected, "connected");
    const std::vector<int> one = m.pieces().of_support(support), two = m.pieces().of_support(other);
    *connected = std::any_of(one.begin(), one.end(),
                             [&](int piece) { return std::binary_search(two.begin(), two.end(), piece); })
                     ? 1
                     : 0;
  });
}

bempd_status bempd_piece_init(bempd_piece* piece, int64_t struct_size) {
  return init_struct(__func__, "piece", piece, struct_size, bempd_piece{});
}

bempd_status bempd_get_piece(bempd_model* model, int32_t number, bempd_piece* piece) {
  return with_model(model, __func__, [&](model::Model& m) {
    struct_bytes(piece, "piece");
    const model::PieceState p = m.pieces().state(number);
    const coupling::RigidFit& motion = p.motion;
    write_struct(piece,
                 bempd_piece{
                     .struct_size = sizeof(bempd_piece),
                     .nodes = p.nodes,
                     .supports = p.supports,
                     .loads = p.loads,
                     .free_motions = p.free_motions,
                     .reserved = 0,
                     .x = motion.centre.x(),
                     .y = motion.centre.y(),
                     .move_x = motion.translation.x(),
                     .move_y = motion.translation.y(),
                     .rotation = motion.rotation,
                     .deviation = motion.deviation,
                 },
                 "piece");
  });
}
