//! A Vulkan device that runs one kernel.

use std::sync::mpsc;

use pollster::block_on;
use wgpu::util::{BufferInitDescriptor, DeviceExt, DownloadBuffer};
use wgpu::{
    BindGroupDescriptor, BindGroupEntry, BufferDescriptor, BufferUsages, CommandEncoderDescriptor,
    ComputePassDescriptor, ComputePipeline, ComputePipelineDescriptor, Device, DeviceDescriptor,
    Instance, InstanceDescriptor, PipelineCompilationOptions, PollType, Queue,
    RequestAdapterOptions, ShaderModuleDescriptor, ShaderSource,
};

use crate::Result;

pub struct Gpu {
    pub name: String,
    device: Device,
    queue: Queue,
}

impl Gpu {
    pub fn new() -> Result<Self> {
        let instance = Instance::new(InstanceDescriptor::new_without_display_handle());
        let adapter = block_on(instance.request_adapter(&RequestAdapterOptions::default()))?;
        let (device, queue) = block_on(adapter.request_device(&DeviceDescriptor::default()))?;
        let info = adapter.get_info();
        let name = format!("{}, {} {}", info.name, info.driver, info.driver_info);
        Ok(Self {
            name,
            device,
            queue,
        })
    }

    /// The function `main` of a shader.
    pub fn kernel(&self, source: ShaderSource) -> Kernel<'_> {
        let module = self.device.create_shader_module(ShaderModuleDescriptor {
            label: None,
            source,
        });
        let pipeline = self
            .device
            .create_compute_pipeline(&ComputePipelineDescriptor {
                label: None,
                layout: None,
                module: &module,
                entry_point: Some("main"),
                compilation_options: PipelineCompilationOptions::default(),
                cache: None,
            });
        Kernel {
            gpu: self,
            pipeline,
        }
    }
}

pub struct Kernel<'a> {
    gpu: &'a Gpu,
    pipeline: ComputePipeline,
}

impl Kernel<'_> {
    /// Runs it once for each result, given its buffers; the results stand in the last.
    pub fn run(&self, inputs: &[&[u8]], results: usize, width: usize) -> Vec<f32> {
        let Self { gpu, pipeline } = self;
        let device = &gpu.device;
        let buffer = |contents: &&[u8]| {
            let usage = BufferUsages::STORAGE;
            device.create_buffer_init(&BufferInitDescriptor {
                label: None,
                contents,
                usage,
            })
        };
        let mut buffers: Vec<_> = inputs.iter().map(buffer).collect();
        let size = (4 * width * results) as u64;
        let usage = BufferUsages::STORAGE | BufferUsages::COPY_SRC;
        let output = BufferDescriptor {
            label: None,
            size,
            usage,
            mapped_at_creation: false,
        };
        buffers.push(device.create_buffer(&output));
        let entry = |(binding, buffer): (u32, &'_ wgpu::Buffer)| (binding, buffer.clone());
        let entries: Vec<_> = (0..).zip(&buffers).map(entry).collect();
        let entries: Vec<_> = entries
            .iter()
            .map(|(binding, buffer)| BindGroupEntry {
                binding: *binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let layout = pipeline.get_bind_group_layout(0);
        let group = device.create_bind_group(&BindGroupDescriptor {
            label: None,
            layout: &layout,
            entries: &entries,
        });
        let mut commands = device.create_command_encoder(&CommandEncoderDescriptor::default());
        let mut pass = commands.begin_compute_pass(&ComputePassDescriptor::default());
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups(results.div_ceil(64) as u32, 1, 1);
        drop(pass);
        gpu.queue.submit([commands.finish()]);
        let (done, result) = mpsc::channel();
        let output = buffers.last().expect("the results");
        DownloadBuffer::read_buffer(device, &gpu.queue, &output.slice(..), move |bytes| {
            done.send(bytes).expect("the program waits");
        });
        device
            .poll(PollType::wait_indefinitely())
            .expect("the device");
        let bytes = result.recv().expect("an answer").expect("the results");
        bytemuck::pod_collect_to_vec(&bytes)
    }
}
