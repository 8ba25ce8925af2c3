// Saves and restores attribute groups [GL1.5 §6.1.14, Table 6.2].
//
// choice: a material parameter that follows the current colour is saved as of the push, and follows on after the pop.
#include "api/commands/attribute_stacks.h"

#include <utility>
#include <vector>

#include "api/commands/buffer_selection.h"
#include "api/commands/enables.h"
#include "api/commands/lighting.h"

namespace gouraud::api {
namespace {

template <class Groups>
struct GroupRow {
  GLbitfield bit;
  void (*restore)(Groups& groups, const Groups& saved);
};

template <auto member, class Groups>
void restore(Groups& groups, const Groups& saved) {
  groups.*member = saved.*member;
}

using Attributes = AttributeGroups;
constexpr GroupRow<AttributeGroups> group_rows[] = {
    {GL_CURRENT_BIT, restore<&Attributes::current>},
    {GL_POINT_BIT, restore<&Attributes::point>},
    {GL_LINE_BIT, restore<&Attributes::line>},
    {GL_POLYGON_BIT, restore<&Attributes::polygon>},
    {GL_POLYGON_STIPPLE_BIT, restore<&Attributes::polygon_stipple>},
    {GL_LIGHTING_BIT, restore<&Attributes::lighting>},
    {GL_FOG_BIT, restore<&Attributes::fog>},
    {GL_DEPTH_BUFFER_BIT, restore<&Attributes::depth>},
    {GL_ACCUM_BUFFER_BIT, restore<&Attributes::accum>},
    {GL_STENCIL_BUFFER_BIT, restore<&Attributes::stencil>},
    {GL_VIEWPORT_BIT, restore<&Attributes::viewport>},
    {GL_TRANSFORM_BIT, restore<&Attributes::transform>},
    {GL_COLOR_BUFFER_BIT, restore<&Attributes::color_buffer>},
    {GL_PIXEL_MODE_BIT, restore<&Attributes::pixel>},
    {GL_HINT_BIT, restore<&Attributes::hint>},
    {GL_EVAL_BIT, restore<&Attributes::eval>},
    {GL_TEXTURE_BIT, restore<&Attributes::texture>},
    {GL_TEXTURE_BIT, restore<&Attributes::texture_generation>},
    {GL_SCISSOR_BIT, restore<&Attributes::scissor>},
    {GL_MULTISAMPLE_BIT, restore<&Attributes::multisample>},
    {GL_LIST_BIT, restore<&Attributes::list>},
};

using ClientAttributes = ClientAttributeGroups;
constexpr GroupRow<ClientAttributeGroups> client_group_rows[] = {
    {GL_CLIENT_PIXEL_STORE_BIT, restore<&ClientAttributes::pack>},
    {GL_CLIENT_PIXEL_STORE_BIT, restore<&ClientAttributes::unpack>},
    {GL_CLIENT_PIXEL_STORE_BIT, restore<&ClientAttributes::pack_buffer>},
    {GL_CLIENT_PIXEL_STORE_BIT, restore<&ClientAttributes::unpack_buffer>},
    {GL_CLIENT_VERTEX_ARRAY_BIT, restore<&ClientAttributes::vertex_arrays>},
};

// Every capability is of ENABLE_BIT [GL1.5 Tables 6.6 to 6.27], besides its own group: all that Enable knows.
const std::vector<GLenum>& capabilities() {
  static const std::vector<GLenum> found = [] {
    std::vector<GLenum> caps;
    AttributeGroups groups;
    for (GLenum cap = 0; cap < 0x10000; ++cap) {
      if (find_capability(groups, cap).flag != nullptr) caps.push_back(cap);
    }
    return caps;
  }();
  return found;
}

// Some capabilities are those of the active texture unit.
void restore_enables(AttributeGroups& groups, AttributeGroups& saved) {
  const int active_unit = groups.texture.active_unit;
  for (int unit = 0; unit < max_texture_units; ++unit) {
    groups.texture.active_unit = saved.texture.active_unit = unit;
    for (const GLenum cap : capabilities()) {
      *find_capability(groups, cap).flag = *find_capability(saved, cap).flag;
    }
  }
  groups.texture.active_unit = active_unit;
}

std::vector<TextureParameters> parameters_of_bound_textures(const TextureGroup& group) {
  std::vector<TextureParameters> result;
  for (const TextureUnit& unit : group.units) {
    for (const TextureBinding& texture : unit.binding) result.push_back(texture->parameters);
  }
  return result;
}

// The parameters go back to the objects that had them, which are bound again.
// choice: where an object was deleted since, the default texture is bound, with the parameters that it has now.
void restore_textures(Context& context, const SavedAttributes& saved) {
  auto parameters = saved.texture_parameters.begin();
  for (TextureUnit& unit : context.state.texture.units) {
    for (TextureBinding& texture : unit.binding) {
      if (texture->name != 0 && context.texture_names().find(texture->name) != texture) {
        texture = context.default_texture(texture->target);
      } else {
        texture->parameters = *parameters;
      }
      ++parameters;
    }
  }
}

}  // namespace

void PushAttrib(Context& context, GLbitfield mask) {
  std::vector<SavedAttributes>& stack = context.attribute_stacks.server;
  if (stack.size() >= static_cast<std::size_t>(max_attrib_stack_depth)) {
    return context.record_error(GL_STACK_OVERFLOW, "glPushAttrib", "the stack is full");
  }
  sync_color_material(context.state);
  SavedAttributes saved{mask, context.state, {}};
  saved.groups.color_buffer.draw_buffer = context.framebuffers.draw->draw_buffer;
  saved.groups.pixel.read_buffer = context.framebuffers.read->read_buffer;
  if ((mask & GL_TEXTURE_BIT) != 0) saved.texture_parameters = parameters_of_bound_textures(context.state.texture);
  stack.push_back(std::move(saved));
}

void PopAttrib(Context& context) {
  std::vector<SavedAttributes>& stack = context.attribute_stacks.server;
  if (stack.empty()) return context.record_error(GL_STACK_UNDERFLOW, "glPopAttrib", "the stack is empty");
  sync_color_material(context.state);
  SavedAttributes& saved = stack.back();
  AttributeGroups& groups = context.state;
  for (const auto& row : group_rows) {
    if ((saved.mask & row.bit) != 0) row.restore(groups, saved.groups);
  }
  if ((saved.mask & GL_TEXTURE_BIT) != 0) restore_textures(context, saved);
  if ((saved.mask & GL_ENABLE_BIT) != 0) restore_enables(groups, saved.groups);
  if ((saved.mask & GL_COLOR_BUFFER_BIT) != 0) restore_draw_buffer(context, saved.groups.color_buffer.draw_buffer);
  if ((saved.mask & GL_PIXEL_MODE_BIT) != 0) restore_read_buffer(context, saved.groups.pixel.read_buffer);
  stack.pop_back();
  context.change(dirty_all);
}

void PushClientAttrib(Context& context, GLbitfield mask) {
  std::vector<SavedClientAttributes>& stack = context.attribute_stacks.client;
  if (stack.size() >= static_cast<std::size_t>(max_client_attrib_stack_depth)) {
    return context.record_error(GL_STACK_OVERFLOW, "glPushClientAttrib", "the stack is full");
  }
  stack.push_back({mask, context.state});
}

void PopClientAttrib(Context& context) {
  std::vector<SavedClientAttributes>& stack = context.attribute_stacks.client;
  if (stack.empty()) return context.record_error(GL_STACK_UNDERFLOW, "glPopClientAttrib", "the stack is empty");
  ClientAttributeGroups& groups = context.state;
  for (const auto& row : client_group_rows) {
    if ((stack.back().mask & row.bit) != 0) row.restore(groups, stack.back().groups);
  }
  stack.pop_back();
}

}  // namespace gouraud::api
