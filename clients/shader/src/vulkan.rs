//! A Vulkan device that runs kernels. What it allocates is freed when the process ends.

use std::ffi::CString;
use std::marker::PhantomData;
use std::slice;

use ash::{Device, Entry, Instance, vk};
use bytemuck::Pod;

use crate::module::{FloatControls, exact};

/// Threads of a workgroup, as the kernels have them.
const THREADS: usize = 64;

type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

pub struct Gpu {
    pub name: String,
    pub controls: FloatControls,
    device: Device,
    queue: vk::Queue,
    commands: vk::CommandBuffer,
    memory: vk::PhysicalDeviceMemoryProperties,
    module: vk::ShaderModule,
    // the functions of the devices come from it
    _entry: Entry,
}

/// Numbers that the CPU and the GPU both see.
pub struct Buffer<T> {
    buffer: vk::Buffer,
    memory: *mut T,
    len: usize,
    item: PhantomData<T>,
}

impl<T: Pod> Buffer<T> {
    pub fn numbers(&mut self) -> &mut [T] {
        // SAFETY: `memory` is mapped for as long as the process runs, it is `len` times as large as
        // T, of which every bit pattern is one, and no kernel runs: `Gpu::run` waits for its end.
        unsafe { slice::from_raw_parts_mut(self.memory, self.len) }
    }
}

/// A buffer of any type.
pub struct Binding(vk::Buffer);

impl<T> From<&Buffer<T>> for Binding {
    fn from(buffer: &Buffer<T>) -> Self {
        Self(buffer.buffer)
    }
}

pub struct Kernel {
    pipeline: vk::Pipeline,
    layout: vk::PipelineLayout,
    set: vk::DescriptorSet,
}

// SAFETY of all of this file: each structure is filled as the Vulkan specification says, names objects of the one
// device, and outlives the call. The validation layers find nothing.
impl Gpu {
    /// The device with this index, in the order in which the drivers list them.
    pub fn new(number: usize, module: &[u32]) -> Result<Self> {
        unsafe {
            let entry = Entry::load()?;
            let application = vk::ApplicationInfo::default().api_version(vk::API_VERSION_1_2);
            let info = vk::InstanceCreateInfo::default().application_info(&application);
            let instance = entry.create_instance(&info, None)?;
            let devices = instance.enumerate_physical_devices()?;
            let physical = *devices.get(number).ok_or("no such Vulkan device")?;
            let (name, controls) = properties(&instance, physical)?;

            let families = instance.get_physical_device_queue_family_properties(physical);
            let computes = |family: &vk::QueueFamilyProperties| {
                family.queue_flags.contains(vk::QueueFlags::COMPUTE)
            };
            let family = families
                .iter()
                .position(computes)
                .ok_or("it cannot compute")? as u32;
            let queues = [vk::DeviceQueueCreateInfo::default()
                .queue_family_index(family)
                .queue_priorities(&[1.0])];
            // the memory model of what rust-gpu compiles
            let mut model =
                vk::PhysicalDeviceVulkanMemoryModelFeatures::default().vulkan_memory_model(true);
            let info = vk::DeviceCreateInfo::default()
                .queue_create_infos(&queues)
                .push_next(&mut model);
            let device = instance.create_device(physical, &info, None)?;

            let info = vk::CommandPoolCreateInfo::default()
                .queue_family_index(family)
                .flags(vk::CommandPoolCreateFlags::RESET_COMMAND_BUFFER);
            let pool = device.create_command_pool(&info, None)?;
            let commands = vk::CommandBufferAllocateInfo::default()
                .command_pool(pool)
                .command_buffer_count(1);
            let module = exact(module, controls);
            let module = vk::ShaderModuleCreateInfo::default().code(&module);
            Ok(Self {
                name,
                controls,
                queue: device.get_device_queue(family, 0),
                commands: device.allocate_command_buffers(&commands)?[0],
                memory: instance.get_physical_device_memory_properties(physical),
                module: device.create_shader_module(&module, None)?,
                device,
                _entry: entry,
            })
        }
    }

    pub fn buffer<T: Pod>(&self, len: usize) -> Result<Buffer<T>> {
        let size = (len * size_of::<T>()) as u64;
        unsafe {
            let info = vk::BufferCreateInfo::default()
                .size(size)
                .usage(vk::BufferUsageFlags::STORAGE_BUFFER);
            let buffer = self.device.create_buffer(&info, None)?;
            let needs = self.device.get_buffer_memory_requirements(buffer);
            let shared =
                vk::MemoryPropertyFlags::HOST_VISIBLE | vk::MemoryPropertyFlags::HOST_COHERENT;
            let suits = |(i, kind): &(usize, &vk::MemoryType)| {
                needs.memory_type_bits >> i & 1 == 1 && kind.property_flags.contains(shared)
            };
            let kinds = self.memory.memory_types_as_slice();
            let (kind, _) = kinds
                .iter()
                .enumerate()
                .find(suits)
                .ok_or("no memory is shared")?;
            let info = vk::MemoryAllocateInfo::default()
                .allocation_size(needs.size)
                .memory_type_index(kind as u32);
            let memory = self.device.allocate_memory(&info, None)?;
            self.device.bind_buffer_memory(buffer, memory, 0)?;
            let memory = self
                .device
                .map_memory(memory, 0, size, vk::MemoryMapFlags::empty())?;
            Ok(Buffer {
                buffer,
                memory: memory.cast(),
                len,
                item: PhantomData,
            })
        }
    }

    /// An entry point with the value of its specialization constant, and the buffers in their order.
    pub fn kernel(&self, entry_point: &str, constant: u32, buffers: &[Binding]) -> Result<Kernel> {
        let kind = vk::DescriptorType::STORAGE_BUFFER;
        let count = buffers.len() as u32;
        let bindings: Vec<_> = (0..count)
            .map(|i| {
                vk::DescriptorSetLayoutBinding::default()
                    .binding(i)
                    .descriptor_type(kind)
                    .descriptor_count(1)
                    .stage_flags(vk::ShaderStageFlags::COMPUTE)
            })
            .collect();
        let name = CString::new(entry_point)?;
        let constant = constant.to_ne_bytes();
        let entries = [vk::SpecializationMapEntry::default().size(constant.len())];
        let constants = vk::SpecializationInfo::default()
            .map_entries(&entries)
            .data(&constant);
        unsafe {
            let info = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
            let sets = [self.device.create_descriptor_set_layout(&info, None)?];
            let info = vk::PipelineLayoutCreateInfo::default().set_layouts(&sets);
            let layout = self.device.create_pipeline_layout(&info, None)?;
            let stage = vk::PipelineShaderStageCreateInfo::default()
                .stage(vk::ShaderStageFlags::COMPUTE)
                .module(self.module)
                .name(&name)
                .specialization_info(&constants);
            let info = [vk::ComputePipelineCreateInfo::default()
                .layout(layout)
                .stage(stage)];
            let pipelines =
                self.device
                    .create_compute_pipelines(vk::PipelineCache::null(), &info, None);
            let pipeline = pipelines.map_err(|(_, error)| error)?[0];

            let sizes = [vk::DescriptorPoolSize {
                ty: kind,
                descriptor_count: count,
            }];
            let info = vk::DescriptorPoolCreateInfo::default()
                .max_sets(1)
                .pool_sizes(&sizes);
            let pool = self.device.create_descriptor_pool(&info, None)?;
            let info = vk::DescriptorSetAllocateInfo::default()
                .descriptor_pool(pool)
                .set_layouts(&sets);
            let set = self.device.allocate_descriptor_sets(&info)?[0];
            for (i, buffer) in (0..).zip(buffers) {
                let whole = [vk::DescriptorBufferInfo::default()
                    .buffer(buffer.0)
                    .range(vk::WHOLE_SIZE)];
                let write = vk::WriteDescriptorSet::default()
                    .dst_set(set)
                    .dst_binding(i)
                    .descriptor_type(kind)
                    .buffer_info(&whole);
                self.device.update_descriptor_sets(&[write], &[]);
            }
            Ok(Kernel {
                pipeline,
                layout,
                set,
            })
        }
    }

    /// Runs a kernel for this many items, until the last is done.
    pub fn run(&self, kernel: &Kernel, items: usize) -> Result<()> {
        let compute = vk::PipelineBindPoint::COMPUTE;
        let commands = [self.commands];
        unsafe {
            self.device
                .begin_command_buffer(self.commands, &vk::CommandBufferBeginInfo::default())?;
            self.device
                .cmd_bind_pipeline(self.commands, compute, kernel.pipeline);
            let (layout, sets) = (kernel.layout, [kernel.set]);
            self.device
                .cmd_bind_descriptor_sets(self.commands, compute, layout, 0, &sets, &[]);
            self.device
                .cmd_dispatch(self.commands, items.div_ceil(THREADS) as u32, 1, 1);
            // the CPU reads what the GPU wrote
            let barrier = [vk::MemoryBarrier::default()
                .src_access_mask(vk::AccessFlags::SHADER_WRITE)
                .dst_access_mask(vk::AccessFlags::HOST_READ)];
            let (from, to) = (
                vk::PipelineStageFlags::COMPUTE_SHADER,
                vk::PipelineStageFlags::HOST,
            );
            let none = vk::DependencyFlags::empty();
            self.device
                .cmd_pipeline_barrier(self.commands, from, to, none, &barrier, &[], &[]);
            self.device.end_command_buffer(self.commands)?;
            let work = [vk::SubmitInfo::default().command_buffers(&commands)];
            self.device
                .queue_submit(self.queue, &work, vk::Fence::null())?;
            Ok(self.device.queue_wait_idle(self.queue)?)
        }
    }
}

/// The name of a device with its driver's, and what it keeps of IEEE 754.
fn properties(instance: &Instance, device: vk::PhysicalDevice) -> Result<(String, FloatControls)> {
    let (mut driver, mut floats) = (
        vk::PhysicalDeviceDriverProperties::default(),
        vk::PhysicalDeviceFloatControlsProperties::default(),
    );
    let mut all = vk::PhysicalDeviceProperties2::default()
        .push_next(&mut driver)
        .push_next(&mut floats);
    unsafe { instance.get_physical_device_properties2(device, &mut all) };
    let name = all
        .properties
        .device_name_as_c_str()?
        .to_string_lossy()
        .into_owned();
    let driver = driver.driver_info_as_c_str()?.to_string_lossy();
    let controls = FloatControls {
        subnormals: floats.shader_denorm_preserve_float32 == vk::TRUE,
        zeros_and_infinities: floats.shader_signed_zero_inf_nan_preserve_float32 == vk::TRUE,
        round_to_even: floats.shader_rounding_mode_rte_float32 == vk::TRUE,
    };
    Ok((format!("{name}, {driver}"), controls))
}
